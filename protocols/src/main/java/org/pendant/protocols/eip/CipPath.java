package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * CIP path: what a message is for, a padded path of segments (CIP volume 1, appendix C).
 *
 * @param key what the device must be
 * @param objectClass number of the class
 * @param instances numbers of an instance and of connection points, in their order
 * @param attribute number of an attribute
 * @param dataBytes of data segments
 */
record CipPath(
    Optional<ElectronicKey> key,
    OptionalInt objectClass,
    List<Integer> instances,
    OptionalInt attribute,
    int dataBytes) {
  private static final int MAX_INSTANCES = 4;

  CipPath {
    instances = List.copyOf(instances);
  }

  /**
   * Reads a path to the end of a buffer.
   *
   * @throws CipRefusal if a segment is cut off or of a kind that no path here has
   */
  static CipPath decode(ByteBuffer bytes) throws CipRefusal {
    Reader reader = new Reader(bytes.slice().order(ByteOrder.LITTLE_ENDIAN));
    while (reader.in.hasRemaining()) {
      reader.segment();
    }
    return new CipPath(
        reader.key, reader.objectClass, reader.instances, reader.attribute, reader.dataBytes);
  }

  private static final class Reader {
    private final ByteBuffer in;
    private Optional<ElectronicKey> key = Optional.empty();
    private OptionalInt objectClass = OptionalInt.empty();
    private final List<Integer> instances = new ArrayList<>();
    private OptionalInt attribute = OptionalInt.empty();
    private int dataBytes;

    Reader(ByteBuffer in) {
      this.in = in;
    }

    void segment() throws CipRefusal {
      int type = u8();
      switch (type) {
        case 0x20 -> objectClass = OptionalInt.of(u8());
        case 0x21 -> objectClass = OptionalInt.of(padded16());
        case 0x24, 0x2C -> instance(u8());
        case 0x25, 0x2D -> instance(padded16());
        case 0x30 -> attribute = OptionalInt.of(u8());
        case 0x31 -> attribute = OptionalInt.of(padded16());
        case 0x34 -> key = Optional.of(key());
        case 0x80 -> {
          int length = 2 * u8();
          dataBytes += length;
          skip(length);
        }
        default -> {
          if (type >= 0x20) {
            throw new CipRefusal(CipRefusal.PATH_SEGMENT);
          }
          port(type);
        }
      }
    }

    /** A way through other devices: there are none behind this one, so it ends here. */
    private void port(int type) throws CipRefusal {
      if ((type & 0x0F) == 0x0F) {
        throw new CipRefusal(CipRefusal.PATH_SEGMENT);
      }
      if ((type & 0x10) == 0) {
        u8();
      } else {
        int length = u8();
        skip(length + length % 2);
      }
    }

    private void instance(int number) throws CipRefusal {
      if (instances.size() == MAX_INSTANCES) {
        throw new CipRefusal(CipRefusal.PATH_SEGMENT);
      }
      instances.add(number);
    }

    private ElectronicKey key() throws CipRefusal {
      if (u8() != 4) {
        throw new CipRefusal(CipRefusal.PATH_SEGMENT);
      }
      int vendor = u16();
      int deviceType = u16();
      int productCode = u16();
      int major = u8();
      int minor = u8();
      return new ElectronicKey(
          vendor, deviceType, productCode, (major & 0x80) != 0, major & 0x7F, minor);
    }

    private int padded16() throws CipRefusal {
      u8();
      return u16();
    }

    private int u16() throws CipRefusal {
      int low = u8();
      return low | u8() << 8;
    }

    private int u8() throws CipRefusal {
      if (!in.hasRemaining()) {
        throw new CipRefusal(CipRefusal.PATH_SEGMENT);
      }
      return Byte.toUnsignedInt(in.get());
    }

    private void skip(int count) throws CipRefusal {
      if (in.remaining() < count) {
        throw new CipRefusal(CipRefusal.PATH_SEGMENT);
      }
      in.position(in.position() + count);
    }
  }
}
