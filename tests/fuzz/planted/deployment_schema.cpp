// This is a schema that lets everything through: the deployment's fuzzer must say so.

#include <suture/deploy/document/schema_check.h>

namespace suture {

const char* deploymentSchema() { return "{}"; }

}  // namespace suture
