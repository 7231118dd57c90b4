package org.pendant.protocols.modbus;

import static org.pendant.protocols.modbus.ModbusTexts.text;

import com.ghgande.j2mod.modbus.Modbus;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** Modbus dissector: requests and answers (Modbus application protocol V1.1b3). */
public final class ModbusDissector implements Dissector {
  private static final int LENGTH_AT = 4;
  private static final int EXCEPTION = 0x80;

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    if (bytes.remaining() < ModbusFrameReader.PREFIX) {
      return MORE;
    }
    int rest = Short.toUnsignedInt(bytes.getShort(bytes.position() + LENGTH_AT));
    return rest < ModbusFrameReader.MIN_REST || rest > ModbusFrameReader.MAX_REST
        ? UNKNOWN
        : ModbusFrameReader.PREFIX + rest;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    int transaction = Short.toUnsignedInt(message.getShort(message.position()));
    int unit = Byte.toUnsignedInt(message.get(message.position() + ModbusFrameReader.PREFIX));
    ByteBuffer body = message.position(message.position() + ModbusFrameReader.PREFIX + 1).slice();
    int function = Byte.toUnsignedInt(body.get());
    Reading reading = direction == Direction.IN ? request(function, body) : answer(function, body);
    return reading.withFields(
        () -> {
          Map<String, Object> fields = Fields.of("transaction", transaction, "unit", unit);
          fields.put("function", function);
          fields.putAll(reading.fields().get());
          return fields;
        });
  }

  private static String name(int function) {
    return switch (function) {
      case Modbus.READ_COILS -> "read-coils";
      case Modbus.READ_INPUT_DISCRETES -> "read-discrete-inputs";
      case Modbus.READ_MULTIPLE_REGISTERS -> "read-registers";
      case Modbus.READ_INPUT_REGISTERS -> "read-input-registers";
      case Modbus.WRITE_COIL -> "write-coil";
      case Modbus.WRITE_SINGLE_REGISTER -> "write-register";
      case Modbus.WRITE_MULTIPLE_COILS -> "write-coils";
      case Modbus.WRITE_MULTIPLE_REGISTERS -> "write-registers";
      case Modbus.READ_WRITE_MULTIPLE -> "write-and-read-registers";
      default -> "function-" + function;
    };
  }

  private static Reading request(int function, ByteBuffer body) {
    String name = name(function);
    return switch (function) {
      case Modbus.READ_COILS,
          Modbus.READ_INPUT_DISCRETES,
          Modbus.READ_MULTIPLE_REGISTERS,
          Modbus.READ_INPUT_REGISTERS -> {
        int address = u16(body);
        int count = u16(body);
        yield Reading.of(
            name,
            text("readsFrom", name, address, count),
            () -> Fields.of("address", address, "count", count));
      }
      case Modbus.WRITE_COIL, Modbus.WRITE_SINGLE_REGISTER -> {
        int address = u16(body);
        int raw = u16(body);
        int value = function == Modbus.WRITE_COIL ? (raw == 0 ? 0 : 1) : raw;
        boolean coil = function == Modbus.WRITE_COIL;
        yield Reading.of(
                name,
                text(coil ? "coil" : "register", address, value),
                () -> Fields.of("address", address, "value", value))
            .doing(text(coil ? "setsCoil" : "setsRegister", address, value));
      }
      case Modbus.WRITE_MULTIPLE_REGISTERS -> {
        int address = u16(body);
        int count = u16(body);
        body.get(); // how many bytes
        List<Integer> values = words(body);
        int last = address + count - 1;
        yield Reading.of(
                name,
                text("registers", address, last, values),
                () -> Fields.of("address", address, "values", values))
            .doing(text("setsRegisters", address, last, values));
      }
      case Modbus.WRITE_MULTIPLE_COILS -> {
        int address = u16(body);
        int count = u16(body);
        int last = address + count - 1;
        yield Reading.of(
                name,
                text("coils", address, last),
                () -> Fields.of("address", address, "count", count))
            .doing(text("setsCoils", address, last));
      }
      case Modbus.READ_WRITE_MULTIPLE ->
          Reading.of(name, name).doing(text("setsRegistersOfExchange"));
      default -> Reading.of(name, name);
    };
  }

  private static Reading answer(int function, ByteBuffer body) {
    if ((function & EXCEPTION) != 0) {
      int code = Byte.toUnsignedInt(body.get());
      String name = name(function & ~EXCEPTION);
      return Reading.of(
          name, text("refusedWithException", code), () -> Fields.of("exception", code));
    }
    String name = name(function);
    return switch (function) {
      case Modbus.READ_MULTIPLE_REGISTERS,
          Modbus.READ_INPUT_REGISTERS,
          Modbus.READ_WRITE_MULTIPLE -> {
        body.get(); // how many bytes
        List<Integer> values = words(body);
        yield Reading.of(name, text("values", values), () -> Fields.of("values", values));
      }
      case Modbus.READ_COILS, Modbus.READ_INPUT_DISCRETES -> {
        body.get(); // how many bytes
        StringBuilder bits = new StringBuilder();
        while (body.hasRemaining()) {
          int each = Byte.toUnsignedInt(body.get());
          for (int i = 0; i < Byte.SIZE; i++) {
            bits.append(each >> i & 1);
          }
        }
        yield Reading.of(name, text("bits", bits), () -> Fields.of("bits", bits.toString()));
      }
      default -> Reading.of(name, text("done"));
    };
  }

  private static int u16(ByteBuffer body) {
    return Short.toUnsignedInt(body.getShort());
  }

  private static List<Integer> words(ByteBuffer body) {
    List<Integer> words = new ArrayList<>();
    while (body.remaining() >= Short.BYTES) {
      words.add(u16(body));
    }
    return words;
  }
}
