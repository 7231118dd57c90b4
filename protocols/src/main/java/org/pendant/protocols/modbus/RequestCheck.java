package org.pendant.protocols.modbus;

import com.ghgande.j2mod.modbus.Modbus;
import java.nio.ByteBuffer;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/**
 * Request check: whether a request is what the Modbus application protocol (V1.1b3, section 6)
 * allows, before it is decoded: the library that decodes takes numbers and lengths as they come.
 */
final class RequestCheck {
  /** Most bits that one request reads. */
  static final int MAX_BITS_READ = 2000;

  /** Most bits that one request writes. */
  static final int MAX_BITS_WRITTEN = 1968;

  /** Most registers that one request reads. */
  static final int MAX_REGISTERS_READ = 125;

  /** Most registers that one request writes. */
  static final int MAX_REGISTERS_WRITTEN = 123;

  /** Most registers that a request writes that reads as well. */
  static final int MAX_WRITTEN_AND_READ = 121;

  /** Where unit, function and what belongs to the function stand in a frame. */
  private static final int FUNCTION_AT = 7;

  private static final int ADDRESSES = 1 << 16;
  private static final int COIL_ON = 0xFF00;

  private final ByteBuffer body;

  private RequestCheck(ByteBuffer body) {
    this.body = body;
  }

  /** The function that a frame asks for, 0 to 255. */
  static int function(byte[] frame) {
    return frame[FUNCTION_AT] & 0xFF;
  }

  /**
   * Checks a whole frame.
   *
   * @throws RefusedRequest if function, address range, numbers or length are wrong
   */
  static void check(byte[] frame) throws RefusedRequest {
    int begin = FUNCTION_AT + 1;
    new RequestCheck(ByteBuffer.wrap(frame, begin, frame.length - begin)).check(function(frame));
  }

  private void check(int function) throws RefusedRequest {
    switch (function) {
      case Modbus.READ_COILS, Modbus.READ_INPUT_DISCRETES -> {
        lengthIs(4);
        range(word(), count(MAX_BITS_READ));
      }
      case Modbus.READ_HOLDING_REGISTERS, Modbus.READ_INPUT_REGISTERS -> {
        lengthIs(4);
        range(word(), count(MAX_REGISTERS_READ));
      }
      case Modbus.WRITE_COIL -> {
        lengthIs(4);
        word();
        int value = word();
        require(value == 0 || value == COIL_ON);
      }
      case Modbus.WRITE_SINGLE_REGISTER -> lengthIs(4);
      case Modbus.WRITE_MULTIPLE_COILS -> {
        lengthIsAtLeast(5);
        int address = word();
        int count = count(MAX_BITS_WRITTEN);
        bytesFollow((count + Byte.SIZE - 1) / Byte.SIZE);
        range(address, count);
      }
      case Modbus.WRITE_MULTIPLE_REGISTERS -> {
        lengthIsAtLeast(5);
        int address = word();
        int count = count(MAX_REGISTERS_WRITTEN);
        bytesFollow(Short.BYTES * count);
        range(address, count);
      }
      case Modbus.MASK_WRITE_REGISTER -> lengthIs(6);
      case Modbus.READ_WRITE_MULTIPLE -> {
        lengthIsAtLeast(9);
        int read = word();
        int readCount = count(MAX_REGISTERS_READ);
        int written = word();
        int writtenCount = count(MAX_WRITTEN_AND_READ);
        bytesFollow(Short.BYTES * writtenCount);
        range(read, readCount);
        range(written, writtenCount);
      }
      default -> throw new RefusedRequest(Reason.FUNCTION);
    }
  }

  private int word() {
    return body.getShort() & 0xFFFF;
  }

  private int count(int most) throws RefusedRequest {
    int count = word();
    require(count >= 1 && count <= most);
    return count;
  }

  private void lengthIs(int length) throws RefusedRequest {
    require(body.remaining() == length);
  }

  private void lengthIsAtLeast(int length) throws RefusedRequest {
    require(body.remaining() >= length);
  }

  /** A byte that says how many follow, and as many. */
  private void bytesFollow(int count) throws RefusedRequest {
    require((body.get() & 0xFF) == count && body.remaining() == count);
  }

  private static void range(int address, int count) throws RefusedRequest {
    if (address + count > ADDRESSES) {
      throw new RefusedRequest(Reason.ADDRESS);
    }
  }

  private static void require(boolean right) throws RefusedRequest {
    if (!right) {
      throw new RefusedRequest(Reason.VALUE);
    }
  }
}
