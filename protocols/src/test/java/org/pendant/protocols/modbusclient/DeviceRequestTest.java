package org.pendant.protocols.modbusclient;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.ProtocolException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;

class DeviceRequestTest {
  private static final ModbusAddress DEVICE = new ModbusAddress("d", 502);

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replace(" ", ""));
  }

  private static ModbusExchange exchange(ModbusKind kind, int count) {
    return new ModbusExchange(DEVICE, 0xFE, kind, 0x1234, count, 0x1234, count, false);
  }

  private static void asks(DeviceRequest question, String hex) {
    assertArrayEquals(bytes(hex), question.frame(0xABCD));
  }

  @Test
  void readsWithTheFunctionOfItsKind() {
    asks(
        DeviceRequest.reading(exchange(ModbusKind.DIGITAL_INPUT, 1)),
        "ABCD00000006 FE 02 1234 0001");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.DIGITAL_OUTPUT, 1)),
        "ABCD00000006 FE 01 1234 0001");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.DIGITAL_OUTPUTS, 9)),
        "ABCD00000006 FE 01 1234 0009");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.REGISTER_INPUT, 2)),
        "ABCD00000006 FE 04 1234 0002");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.REGISTER_OUTPUT, 1)),
        "ABCD00000006 FE 03 1234 0001");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.REGISTER_OUTPUTS, 123)),
        "ABCD00000006 FE 03 1234 007B");
    asks(
        DeviceRequest.reading(exchange(ModbusKind.READ_WRITE_REGISTERS, 3)),
        "ABCD00000006 FE 03 1234 0003");
  }

  @Test
  void writesWithTheFunctionOfItsKind() {
    asks(
        DeviceRequest.writing(exchange(ModbusKind.DIGITAL_OUTPUT, 1), List.of(1)),
        "ABCD00000008 FE 0F 1234 0001 01 01");
    asks(
        DeviceRequest.writing(
            exchange(ModbusKind.DIGITAL_OUTPUTS, 9), List.of(1, 0, 1, 0, 0, 0, 0, 0, 1)),
        "ABCD00000009 FE 0F 1234 0009 02 0501");
    asks(
        DeviceRequest.writing(exchange(ModbusKind.REGISTER_OUTPUT, 1), List.of(0xFFFE)),
        "ABCD00000006 FE 06 1234 FFFE");
    asks(
        DeviceRequest.writing(exchange(ModbusKind.REGISTER_OUTPUT, 2), List.of(1, 2)),
        "ABCD0000000B FE 10 1234 0002 04 0001 0002");
    asks(
        DeviceRequest.writing(exchange(ModbusKind.REGISTER_OUTPUTS, 1), List.of(7)),
        "ABCD00000009 FE 10 1234 0001 02 0007");
    asks(
        DeviceRequest.writing(
            new ModbusExchange(
                DEVICE, 0xFE, ModbusKind.READ_WRITE_REGISTERS, 0x1234, 3, 0x4321, 2, false),
            List.of(5, 6)),
        "ABCD0000000F FE 17 1234 0003 4321 0002 04 0005 0006");
  }

  @Test
  void sendsWhatSomebodyElseHasMade() {
    asks(DeviceRequest.made(103, 6, new byte[] {17, 32, 2, 88}), "ABCD00000006 67 06 1120 0258");
    asks(DeviceRequest.made(255, 7, new byte[0]), "ABCD00000002 FF 07");
  }

  @Test
  void readsBitsAndRegistersOutOfAnswers() {
    assertEquals(
        new DeviceResponse.Values(List.of(1, 0, 1, 0, 0, 0, 0, 0, 1)),
        DeviceRequest.reading(exchange(ModbusKind.DIGITAL_OUTPUTS, 9))
            .answer(bytes("ABCD00000005 FE 01 02 05FF")));
    assertEquals(
        new DeviceResponse.Values(List.of(1)),
        DeviceRequest.reading(exchange(ModbusKind.DIGITAL_INPUT, 1))
            .answer(bytes("ABCD00000004 FE 02 01 01")));
    assertEquals(
        new DeviceResponse.Values(List.of(0xFFFF, 0x8001)),
        DeviceRequest.reading(exchange(ModbusKind.REGISTER_INPUT, 2))
            .answer(bytes("ABCD00000007 FE 04 04 FFFF 8001")));
    assertEquals(
        new DeviceResponse.Values(List.of(3)),
        DeviceRequest.reading(exchange(ModbusKind.REGISTER_OUTPUT, 1))
            .answer(bytes("ABCD00000005 FE 03 02 0003")));
    assertEquals(
        new DeviceResponse.Values(List.of(9)),
        DeviceRequest.writing(exchange(ModbusKind.READ_WRITE_REGISTERS, 1), List.of(5))
            .answer(bytes("ABCD00000005 FE 17 02 0009")));
  }

  @Test
  void aWriteIsDoneWhenItIsEchoed() {
    DeviceRequest question =
        DeviceRequest.writing(exchange(ModbusKind.REGISTER_OUTPUTS, 1), List.of(7));
    assertEquals(new DeviceResponse.Done(), question.answer(bytes("ABCD00000006 FE 10 1234 0001")));
    assertEquals(
        new DeviceResponse.Nonsense(), question.answer(bytes("ABCD00000006 FE 10 1234 0002")));
    assertEquals(new DeviceResponse.Nonsense(), question.answer(bytes("ABCD00000004 FE 10 1234")));
  }

  @Test
  void refusalsHaveTheirCode() {
    DeviceRequest question = DeviceRequest.reading(exchange(ModbusKind.REGISTER_INPUT, 1));
    assertEquals(new DeviceResponse.Refused(11), question.answer(bytes("ABCD00000003 FE 84 0B")));
    assertEquals(new DeviceResponse.Nonsense(), question.answer(bytes("ABCD00000003 FE 84 00")));
    assertEquals(new DeviceResponse.Nonsense(), question.answer(bytes("ABCD00000004 FE 84 0B 00")));
    assertEquals(new DeviceResponse.Nonsense(), question.answer(bytes("ABCD00000003 FE 83 0B")));
  }

  @Test
  void answersOfAnotherLengthUnitOrFunctionAreNone() {
    DeviceRequest question = DeviceRequest.reading(exchange(ModbusKind.REGISTER_OUTPUT, 2));
    for (String wrong :
        List.of(
            "ABCD00000007 FD 03 04 0001 0002",
            "ABCD00000007 FE 04 04 0001 0002",
            "ABCD00000007 FE 03 02 0001 0002",
            "ABCD00000005 FE 03 04 0001",
            "ABCD00000009 FE 03 06 0001 0002 0003",
            "ABCD00000003 FE 03 04")) {
      assertEquals(new DeviceResponse.Nonsense(), question.answer(bytes(wrong)), wrong);
    }
  }

  @Test
  void nothingThatADeviceSaysIsMoreThanNonsense() {
    long seed = 20261122;
    Random random = new Random(seed);
    List<ModbusKind> kinds = List.of(ModbusKind.values());
    for (int i = 0; i < 20_000; i++) {
      ModbusKind kind = kinds.get(random.nextInt(kinds.size()));
      // as many as a request takes that reads and writes
      int count = 1 + random.nextInt(121);
      DeviceRequest question =
          kind.output() && random.nextBoolean()
              ? DeviceRequest.writing(
                  exchange(kind, count), random.ints(count, 0, 2).boxed().toList())
              : DeviceRequest.reading(exchange(kind, count));
      byte[] asked = question.frame(1);
      byte[] frame = new byte[ResponseFrame.PREFIX + 3 + random.nextInt(252)];
      random.nextBytes(frame);
      // near enough to be believed now and then
      System.arraycopy(asked, 0, frame, 0, random.nextInt(10));
      assertNotNull(question.answer(frame), () -> seed + ": " + HexFormat.of().formatHex(frame));
    }
  }

  @Test
  void framesAreCutOutOfWhatComes() throws IOException {
    byte[] two = bytes("0001 0000 0003 FF 84 02 0002 0000 0005 FF 03 02 0007");
    ByteArrayInputStream in = new ByteArrayInputStream(two);
    assertArrayEquals(bytes("0001 0000 0003 FF 84 02"), ResponseFrame.read(in));
    byte[] second = ResponseFrame.read(in);
    assertArrayEquals(bytes("0002 0000 0005 FF 03 02 0007"), second);
    assertEquals(2, ResponseFrame.transaction(second));
    assertThrows(EOFException.class, () -> ResponseFrame.read(in));
  }

  @Test
  void framesThatAreCutShortEndTheConnection() {
    byte[] frame = bytes("0002 0000 0005 FF 03 02 0007");
    for (int i = 0; i < frame.length; i++) {
      byte[] part = Arrays.copyOf(frame, i);
      assertInstanceOf(
          EOFException.class,
          assertThrows(
              IOException.class, () -> ResponseFrame.read(new ByteArrayInputStream(part))));
    }
  }

  @Test
  void absurdLengthsAndOtherProtocolsAreNoModbus() {
    for (String wrong :
        List.of(
            "0001 0000 0002 FF 84",
            "0001 0000 00FF FF 03 02",
            "0001 0000 FFFF FF 03 02",
            "0001 0001 0005 FF 03 02 0007",
            "4854 5450 2F31 2E31")) {
      byte[] bytes = bytes(wrong);
      assertThrows(
          ProtocolException.class,
          () -> ResponseFrame.read(new ByteArrayInputStream(bytes)),
          wrong);
    }
  }
}
