#include <suture/loop/failure.h>
#include <suture/names/records.h>

namespace suture {
namespace {

using WireInterfaces = capnp::List<wire::InterfaceRecord>;

void interfacesToWire(const std::vector<InterfaceRecord>& interfaces, WireInterfaces::Builder out) {
  for (unsigned i = 0; i < interfaces.size(); ++i) {
    out[i].setName(codec::textOf(interfaces[i].name));
    out[i].setContract(codec::textOf(interfaces[i].contract));
    out[i].setHash(codec::textOf(interfaces[i].hash));
    toWire(interfaces[i].frames, out[i].initFrames());
  }
}

std::vector<InterfaceRecord> interfacesFromWire(WireInterfaces::Reader in) {
  std::vector<InterfaceRecord> interfaces;
  for (const auto& one : in) {
    interfaces.push_back({codec::stringOf(one.getName()), codec::stringOf(one.getContract()),
                          codec::stringOf(one.getHash()), fromWire(one.getFrames())});
  }
  return interfaces;
}

std::size_t bytesOf(const std::vector<InterfaceRecord>& interfaces) {
  std::size_t bytes = 0;
  for (const InterfaceRecord& one : interfaces) {
    bytes += sizeof(one) + one.name.size() + one.contract.size() + one.hash.size() +
             one.frames.reference.size() + one.frames.moving.size();
  }
  return bytes;
}

unsigned sizeOf(const auto& list) { return static_cast<unsigned>(list.size()); }

}  // namespace

std::size_t bytesOf(const std::vector<ComponentRecord>& components) {
  std::size_t bytes = 0;
  for (const ComponentRecord& one : components) {
    bytes += sizeof(one) + one.name.size() + bytesOf(one.provided) + bytesOf(one.required);
  }
  return bytes;
}

std::size_t bytesOf(const ProcessRecord& process) {
  std::size_t bytes = sizeof(process) + process.name.size() + process.host.size();
  for (const std::string& address : process.addresses) {
    bytes += sizeof(std::string) + address.size();
  }
  return bytes + bytesOf(process.components);
}

void toWire(const std::vector<ComponentRecord>& components,
            capnp::List<wire::ComponentRecord>::Builder out) {
  for (unsigned i = 0; i < components.size(); ++i) {
    const ComponentRecord& component = components[i];
    out[i].setName(codec::textOf(component.name));
    interfacesToWire(component.provided, out[i].initProvided(sizeOf(component.provided)));
    interfacesToWire(component.required, out[i].initRequired(sizeOf(component.required)));
  }
}

void toWire(const ProcessRecord& process, wire::ProcessRecord::Builder out) {
  out.setName(codec::textOf(process.name));
  auto addresses = out.initAddresses(sizeOf(process.addresses));
  for (unsigned i = 0; i < process.addresses.size(); ++i) {
    addresses.set(i, codec::textOf(process.addresses[i]));
  }
  out.setPid(process.pid);
  out.setHost(codec::textOf(process.host));
  toWire(process.components, out.initComponents(sizeOf(process.components)));
  out.setGeneration(process.generation);
  out.setSilent(process.silent);
}

void toWire(const Frames& frames, wire::Frames::Builder out) {
  out.setReference(codec::textOf(frames.reference));
  out.setMoving(codec::textOf(frames.moving));
}

void toWire(const Refusal& refusal, wire::Refusal::Builder out) {
  out.setKind(refusal.kind);
  out.setText(codec::textOf(refusal.text));
}

std::vector<ComponentRecord> fromWire(capnp::List<wire::ComponentRecord>::Reader in) {
  std::vector<ComponentRecord> components;
  for (const auto& one : in) {
    components.push_back({codec::stringOf(one.getName()), interfacesFromWire(one.getProvided()),
                          interfacesFromWire(one.getRequired())});
  }
  return components;
}

ProcessRecord fromWire(wire::ProcessRecord::Reader in) {
  ProcessRecord process;
  process.name = codec::stringOf(in.getName());
  for (const auto address : in.getAddresses())
    process.addresses.push_back(codec::stringOf(address));
  process.pid = in.getPid();
  process.host = codec::stringOf(in.getHost());
  process.components = fromWire(in.getComponents());
  process.generation = in.getGeneration();
  process.silent = in.getSilent();
  return process;
}

Frames fromWire(wire::Frames::Reader in) {
  return {codec::stringOf(in.getReference()), codec::stringOf(in.getMoving())};
}

Refusal fromWire(wire::Refusal::Reader in) { return {in.getKind(), codec::stringOf(in.getText())}; }

kj::Exception refused(wire::Refusal::Reader in) {
  return loop::failure(kj::Exception::Type::FAILED, fromWire(in).text);
}

}  // namespace suture
