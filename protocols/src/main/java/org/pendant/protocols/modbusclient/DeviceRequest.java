package org.pendant.protocols.modbusclient;

import com.ghgande.j2mod.modbus.msg.ModbusRequest;
import com.ghgande.j2mod.modbus.msg.ModbusResponse;
import com.ghgande.j2mod.modbus.msg.ReadCoilsRequest;
import com.ghgande.j2mod.modbus.msg.ReadCoilsResponse;
import com.ghgande.j2mod.modbus.msg.ReadInputDiscretesRequest;
import com.ghgande.j2mod.modbus.msg.ReadInputDiscretesResponse;
import com.ghgande.j2mod.modbus.msg.ReadInputRegistersRequest;
import com.ghgande.j2mod.modbus.msg.ReadInputRegistersResponse;
import com.ghgande.j2mod.modbus.msg.ReadMultipleRegistersRequest;
import com.ghgande.j2mod.modbus.msg.ReadMultipleRegistersResponse;
import com.ghgande.j2mod.modbus.msg.ReadWriteMultipleRequest;
import com.ghgande.j2mod.modbus.msg.ReadWriteMultipleResponse;
import com.ghgande.j2mod.modbus.msg.WriteMultipleCoilsRequest;
import com.ghgande.j2mod.modbus.msg.WriteMultipleRegistersRequest;
import com.ghgande.j2mod.modbus.msg.WriteSingleRegisterRequest;
import com.ghgande.j2mod.modbus.procimg.Register;
import com.ghgande.j2mod.modbus.procimg.SimpleRegister;
import com.ghgande.j2mod.modbus.util.BitVector;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import org.pendant.controller.external.ModbusExchange;

/** Device request and how its answer is read. Pure: bytes in, bytes out. */
final class DeviceRequest {
  /** Bytes of an answer to a write: prefix, unit, function, address, count. */
  private static final int WRITTEN_LENGTH = ResponseFrame.PREFIX + 6;

  private static final int EXCEPTION_BIT = 0x80;

  private final byte[] request;
  private final Expected expected;
  private final int values;

  private enum Expected {
    BITS,
    REGISTERS,
    /** Address and count, or address and value, as in the request. */
    ECHO,
    /** Whatever comes. */
    ANYTHING
  }

  private DeviceRequest(byte[] request, Expected expected, int values) {
    this.request = request;
    this.expected = expected;
    this.values = values;
  }

  /** Reads what the exchange reads. */
  static DeviceRequest reading(ModbusExchange exchange) {
    int address = exchange.readAddress();
    int count = exchange.readCount();
    ModbusRequest request =
        switch (exchange.kind()) {
          case DIGITAL_INPUT -> new ReadInputDiscretesRequest(address, count);
          case DIGITAL_OUTPUT, DIGITAL_OUTPUTS -> new ReadCoilsRequest(address, count);
          case REGISTER_INPUT -> new ReadInputRegistersRequest(address, count);
          case REGISTER_OUTPUT, REGISTER_OUTPUTS, READ_WRITE_REGISTERS ->
              new ReadMultipleRegistersRequest(address, count);
        };
    Expected expected = exchange.kind().digital() ? Expected.BITS : Expected.REGISTERS;
    return new DeviceRequest(encoded(request, exchange.unit()), expected, count);
  }

  /**
   * Writes what the exchange writes.
   *
   * @param values as many as it writes
   */
  static DeviceRequest writing(ModbusExchange exchange, List<Integer> values) {
    int address = exchange.writeAddress();
    return switch (exchange.kind()) {
      case DIGITAL_OUTPUT, DIGITAL_OUTPUTS ->
          echoed(exchange, new WriteMultipleCoilsRequest(address, bits(values)));
      case REGISTER_OUTPUT ->
          echoed(
              exchange,
              values.size() == 1
                  ? new WriteSingleRegisterRequest(address, registers(values)[0])
                  : new WriteMultipleRegistersRequest(address, registers(values)));
      case REGISTER_OUTPUTS ->
          echoed(exchange, new WriteMultipleRegistersRequest(address, registers(values)));
      case READ_WRITE_REGISTERS -> readingAndWriting(exchange, values);
      case DIGITAL_INPUT, REGISTER_INPUT ->
          throw new IllegalArgumentException(exchange.kind() + " cannot be written");
    };
  }

  private static DeviceRequest echoed(ModbusExchange exchange, ModbusRequest request) {
    return new DeviceRequest(encoded(request, exchange.unit()), Expected.ECHO, 0);
  }

  private static DeviceRequest readingAndWriting(ModbusExchange exchange, List<Integer> values) {
    ReadWriteMultipleRequest request =
        new ReadWriteMultipleRequest(
            exchange.unit(),
            exchange.readAddress(),
            exchange.readCount(),
            exchange.writeAddress(),
            exchange.writeCount());
    request.setRegisters(registers(values));
    return new DeviceRequest(
        encoded(request, exchange.unit()), Expected.REGISTERS, exchange.readCount());
  }

  /** Sends a request that was made elsewhere. */
  static DeviceRequest made(int unit, int function, byte[] data) {
    ByteBuffer bytes = ByteBuffer.allocate(ResponseFrame.PREFIX + 2 + data.length);
    bytes.putInt(0).putShort((short) (2 + data.length));
    bytes.put((byte) unit).put((byte) function).put(data);
    return new DeviceRequest(bytes.array(), Expected.ANYTHING, 0);
  }

  private static BitVector bits(List<Integer> values) {
    BitVector bits = new BitVector(values.size());
    for (int i = 0; i < values.size(); i++) {
      bits.setBit(i, values.get(i) != 0);
    }
    return bits;
  }

  private static Register[] registers(List<Integer> values) {
    return values.stream().map(SimpleRegister::new).toArray(Register[]::new);
  }

  private static byte[] encoded(ModbusRequest request, int unit) {
    request.setTransactionID(0);
    request.setProtocolID(0);
    request.setUnitID(unit);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      request.writeTo(new DataOutputStream(bytes));
    } catch (IOException e) {
      // an array takes everything
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  /**
   * The bytes to send.
   *
   * @param transaction number by which the device says what it answers, 0 to 65535
   */
  byte[] frame(int transaction) {
    byte[] frame = request.clone();
    ByteBuffer.wrap(frame).putShort((short) transaction);
    return frame;
  }

  /** What a frame that answers this says. */
  DeviceResponse answer(byte[] frame) {
    if (expected == Expected.ANYTHING) {
      return new DeviceResponse.Done();
    }
    int asked = request[ResponseFrame.FUNCTION];
    int function = frame[ResponseFrame.FUNCTION] & 0xFF;
    if (frame[ResponseFrame.PREFIX] != request[ResponseFrame.PREFIX]) {
      return new DeviceResponse.Nonsense();
    }
    if (function == (asked | EXCEPTION_BIT)) {
      return frame.length == ResponseFrame.FUNCTION + 2 && frame[ResponseFrame.FUNCTION + 1] != 0
          ? new DeviceResponse.Refused(frame[ResponseFrame.FUNCTION + 1] & 0xFF)
          : new DeviceResponse.Nonsense();
    }
    if (function != asked) {
      return new DeviceResponse.Nonsense();
    }
    return switch (expected) {
      case BITS -> values(frame, (values + 7) / 8);
      case REGISTERS -> values(frame, 2 * values);
      case ECHO -> echo(frame);
      case ANYTHING -> new DeviceResponse.Done();
    };
  }

  private DeviceResponse echo(byte[] frame) {
    boolean same = frame.length == WRITTEN_LENGTH;
    for (int i = ResponseFrame.FUNCTION; same && i < WRITTEN_LENGTH; i++) {
      same = frame[i] == request[i];
    }
    return same ? new DeviceResponse.Done() : new DeviceResponse.Nonsense();
  }

  private DeviceResponse values(byte[] frame, int bytes) {
    if (frame.length != ResponseFrame.FUNCTION + 2 + bytes
        || (frame[ResponseFrame.FUNCTION + 1] & 0xFF) != bytes) {
      return new DeviceResponse.Nonsense();
    }
    ModbusResponse response =
        ModbusResponse.createModbusResponse(frame[ResponseFrame.FUNCTION] & 0xFF);
    try {
      response.readFrom(new DataInputStream(new ByteArrayInputStream(frame)));
    } catch (IOException e) {
      // an array has no other fault than its end, and the length is checked
      throw new UncheckedIOException(e);
    }
    IntUnaryOperator value =
        switch (response) {
          case ReadCoilsResponse coils -> i -> coils.getCoilStatus(i) ? 1 : 0;
          case ReadInputDiscretesResponse inputs -> i -> inputs.getDiscreteStatus(i) ? 1 : 0;
          case ReadMultipleRegistersResponse registers -> registers::getRegisterValue;
          case ReadInputRegistersResponse registers -> registers::getRegisterValue;
          case ReadWriteMultipleResponse registers -> registers::getRegisterValue;
          default -> throw new IllegalStateException("not asked for: " + response);
        };
    return new DeviceResponse.Values(
        IntStream.range(0, values).map(i -> value.applyAsInt(i) & 0xFFFF).boxed().toList());
  }
}
