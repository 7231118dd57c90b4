package org.pendant.controller.device.plc;

/**
 * Modbus answers of a device: a request in, its answer out, both without unit and checksum, one
 * {@code char} a byte (Modbus V1.1b3, 6). Functions 1 to 6, 15, 16 and 23; anything else is refused
 * with exception 1, an address that is not there with 2, a count, a length or a value that cannot
 * be with 3.
 */
final class ModbusAnswers {
  static final int NO_FUNCTION = 1;
  static final int NO_ADDRESS = 2;
  static final int NO_VALUE = 3;

  /** The unit that was asked is not behind this address: a gateway's answer. */
  static final int NO_UNIT = 11;

  private static final int EXCEPTION = 0x80;
  private static final int MAX_READ_BITS = 2000;
  private static final int MAX_READ_WORDS = 125;
  private static final int MAX_WRITTEN_BITS = 1968;
  private static final int MAX_WRITTEN_WORDS = 123;
  private static final int MAX_BOTH_WRITTEN = 121;
  private static final int ON = 0xFF00;
  private static final int HEAD = 5;
  private static final int TWO_WORDS = 4;
  private static final int BOTH_HEAD = 9;

  private final ModbusMemory memory;

  ModbusAnswers(ModbusMemory memory) {
    this.memory = memory;
  }

  /** Refuses a request. */
  static String refusal(String request, int exception) {
    int function = request.isEmpty() ? 0 : request.charAt(0);
    return "" + (char) (function | EXCEPTION) + (char) exception;
  }

  /** Carries out a request and answers it. */
  String to(String request) {
    if (request.isEmpty()) {
      return refusal(request, NO_FUNCTION);
    }
    String data = request.substring(1);
    return switch (request.charAt(0)) {
      case 1 -> readBits(request, ModbusTable.COIL);
      case 2 -> readBits(request, ModbusTable.INPUT);
      case 3 -> readWords(request, ModbusTable.REGISTER);
      case 4 -> readWords(request, ModbusTable.INPUT_REGISTER);
      case 5 -> writeBit(request);
      case 6 -> writeWord(request);
      case 15 -> writeBits(request);
      case 16 -> writeWords(request);
      case 23 -> readAndWrite(request, data);
      default -> refusal(request, NO_FUNCTION);
    };
  }

  private String readBits(String request, ModbusTable table) {
    String data = request.substring(1);
    int count = data.length() == TWO_WORDS ? word(data, 2) : 0;
    int exception = exception(table, data, count, MAX_READ_BITS);
    if (exception != 0) {
      return refusal(request, exception);
    }
    StringBuilder bytes = new StringBuilder();
    for (int i = 0; i < count; i += Byte.SIZE) {
      int bits = 0;
      for (int bit = 0; bit < Math.min(Byte.SIZE, count - i); bit++) {
        bits |= memory.get(table, word(data, 0) + i + bit) << bit;
      }
      bytes.append((char) bits);
    }
    return "" + request.charAt(0) + (char) bytes.length() + bytes;
  }

  private String readWords(String request, ModbusTable table) {
    String data = request.substring(1);
    int count = data.length() == TWO_WORDS ? word(data, 2) : 0;
    int exception = exception(table, data, count, MAX_READ_WORDS);
    return exception == 0
        ? words(request, table, word(data, 0), count)
        : refusal(request, exception);
  }

  private String words(String request, ModbusTable table, int address, int count) {
    StringBuilder bytes = new StringBuilder();
    for (int i = 0; i < count; i++) {
      int value = memory.get(table, address + i);
      bytes.append((char) (value >> Byte.SIZE)).append((char) (value & 0xFF));
    }
    return "" + request.charAt(0) + (char) bytes.length() + bytes;
  }

  private String writeBit(String request) {
    String data = request.substring(1);
    int value = data.length() == TWO_WORDS ? word(data, 2) : 1;
    int exception = value == 0 || value == ON ? exception(ModbusTable.COIL, data, 1, 1) : NO_VALUE;
    if (exception != 0) {
      return refusal(request, exception);
    }
    memory.set(ModbusTable.COIL, word(data, 0), value == ON ? 1 : 0);
    return request;
  }

  private String writeWord(String request) {
    String data = request.substring(1);
    int exception =
        data.length() == TWO_WORDS ? exception(ModbusTable.REGISTER, data, 1, 1) : NO_VALUE;
    if (exception != 0) {
      return refusal(request, exception);
    }
    memory.set(ModbusTable.REGISTER, word(data, 0), word(data, 2));
    return request;
  }

  private String writeBits(String request) {
    String data = request.substring(1);
    int count = data.length() > HEAD ? word(data, 2) : 0;
    int bytes = (count + Byte.SIZE - 1) / Byte.SIZE;
    int exception =
        fits(data, HEAD, bytes)
            ? exception(ModbusTable.COIL, data, count, MAX_WRITTEN_BITS)
            : NO_VALUE;
    if (exception != 0) {
      return refusal(request, exception);
    }
    for (int i = 0; i < count; i++) {
      int bit = data.charAt(HEAD + i / Byte.SIZE) >> i % Byte.SIZE & 1;
      memory.set(ModbusTable.COIL, word(data, 0) + i, bit);
    }
    return request.substring(0, HEAD);
  }

  private String writeWords(String request) {
    String data = request.substring(1);
    int count = data.length() > HEAD ? word(data, 2) : 0;
    int exception =
        fits(data, HEAD, 2 * count)
            ? exception(ModbusTable.REGISTER, data, count, MAX_WRITTEN_WORDS)
            : NO_VALUE;
    if (exception != 0) {
      return refusal(request, exception);
    }
    write(word(data, 0), data.substring(HEAD));
    return request.substring(0, HEAD);
  }

  /** Writes before it reads. */
  private String readAndWrite(String request, String data) {
    if (data.length() <= BOTH_HEAD) {
      return refusal(request, NO_VALUE);
    }
    int count = word(data, 2);
    String writing = data.substring(TWO_WORDS);
    int written = word(writing, 2);
    int exception =
        fits(writing, HEAD, 2 * written)
            ? exception(ModbusTable.REGISTER, writing, written, MAX_BOTH_WRITTEN)
            : NO_VALUE;
    if (exception == 0) {
      exception = exception(ModbusTable.REGISTER, data, count, MAX_READ_WORDS);
    }
    if (exception != 0) {
      return refusal(request, exception);
    }
    write(word(writing, 0), writing.substring(HEAD));
    return words(request, ModbusTable.REGISTER, word(data, 0), count);
  }

  private void write(int address, String words) {
    for (int i = 0; 2 * i < words.length(); i++) {
      memory.set(ModbusTable.REGISTER, address + i, word(words, 2 * i));
    }
  }

  /** Whether what follows the head has as many bytes as its last byte tells, and as it must. */
  private static boolean fits(String data, int head, int bytes) {
    return data.length() == head + bytes && data.charAt(head - 1) == bytes;
  }

  /** What is wrong with the addresses in the first word on; 0 for nothing. */
  private int exception(ModbusTable table, String data, int count, int most) {
    if (count < 1 || count > most) {
      return NO_VALUE;
    }
    return memory.holds(table, word(data, 0), count) ? 0 : NO_ADDRESS;
  }

  private static int word(String data, int at) {
    return data.charAt(at) << Byte.SIZE | data.charAt(at + 1);
  }
}
