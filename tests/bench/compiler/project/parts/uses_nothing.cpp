// Includes nothing of the project: no edit of a header may touch it.
namespace parts {
int nothing() { return 0; }
}  // namespace parts
