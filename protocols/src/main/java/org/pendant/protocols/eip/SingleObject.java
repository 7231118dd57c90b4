package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Singleton object: a class with one instance.
 *
 * @param attributes from attribute 1 on, each as it is when asked for
 */
record SingleObject(int revision, List<Supplier<LittleEndian>> attributes) implements CipObject {
  SingleObject {
    attributes = List.copyOf(attributes);
  }

  @Override
  public int highestInstance() {
    return 1;
  }

  @Override
  public boolean has(int instance) {
    return instance == 1;
  }

  @Override
  public Optional<ByteBuffer> attribute(int instance, int attribute) {
    return attribute < 1 || attribute > attributes.size()
        ? Optional.empty()
        : Optional.of(attributes.get(attribute - 1).get().toBuffer());
  }

  @Override
  public Optional<ByteBuffer> all(int instance) {
    LittleEndian all = new LittleEndian();
    attributes.forEach(each -> all.bytes(each.get().toBuffer()));
    return Optional.of(all.toBuffer());
  }
}
