package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.util.Optional;

/** CIP object: a class of objects whose attributes can be read (CIP volume 1, chapter 5). */
interface CipObject {
  /** Revision of the class. */
  int revision();

  /** The highest number of an instance. */
  int highestInstance();

  /** Whether there is an instance. */
  boolean has(int instance);

  /** An attribute; empty when there is none. */
  Optional<ByteBuffer> attribute(int instance, int attribute);

  /** All attributes of an instance; empty when they cannot be asked for together. */
  default Optional<ByteBuffer> all(int instance) {
    return Optional.empty();
  }
}
