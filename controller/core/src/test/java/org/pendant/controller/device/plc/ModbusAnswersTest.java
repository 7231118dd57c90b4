package org.pendant.controller.device.plc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ModbusAnswersTest {
  private final ModbusMemory memory =
      new ModbusMemory(
          10,
          Map.of(
              ModbusTable.COIL, 20,
              ModbusTable.INPUT, 20,
              ModbusTable.REGISTER, 8,
              ModbusTable.INPUT_REGISTER, 8));
  private final ModbusAnswers answers = new ModbusAnswers(memory);

  private static String bytes(String hex) {
    return new String(HexFormat.of().parseHex(hex.replace(" ", "")), StandardCharsets.ISO_8859_1);
  }

  private static String hex(String bytes) {
    return HexFormat.of().formatHex(bytes.getBytes(StandardCharsets.ISO_8859_1));
  }

  private String to(String hex) {
    return hex(answers.to(bytes(hex)));
  }

  @Test
  void bitsArePackedFromTheLowest() {
    memory.set(ModbusTable.COIL, 10, 1);
    memory.set(ModbusTable.COIL, 18, 1);
    memory.set(ModbusTable.INPUT, 12, 1);
    assertEquals("01020101", to("01 000a 0009"));
    assertEquals("020104", to("02 000a 0003"));
  }

  @Test
  void registersAreBigEndian() {
    memory.set(ModbusTable.REGISTER, 11, 0x1234);
    memory.set(ModbusTable.INPUT_REGISTER, 17, 0xFFFE);
    assertEquals("030400001234", to("03 000a 0002"));
    assertEquals("0402fffe", to("04 0011 0001"));
  }

  @Test
  void writesAreAnsweredAsTheSpecificationHasThem() {
    assertEquals("05000aff00", to("05 000a ff00"));
    assertEquals("06000b0007", to("06 000b 0007"));
    assertEquals("0f000a000a", to("0f 000a 000a 02 cd01"));
    assertEquals("10000c0002", to("10 000c 0002 04 000a0102"));
    assertEquals("0102cd01", to("01 000a 000a"));
    assertEquals("03080007000a01020000", to("03 000b 0004"));
  }

  @Test
  void readingAndWritingWritesFirst() {
    assertEquals("17040009000a", to("17 000a 0002 000a 0002 04 0009 000a"));
  }

  @ParameterizedTest
  @CsvSource({
    "01 0009 0001, 8102",
    "01 0000 0000, 8103",
    "02 001d 0002, 8202",
    "03 0011 0002, 8302",
    "03 000a 007e, 8303",
    "04 000a, 8403",
    "05 000a 0001, 8503",
    "05 0000 ff00, 8502",
    "06 0012 0001, 8602",
    "06 000a, 8603",
    "0f 000a 0009 01 ff, 8f03",
    "10 000a 0002 04 0001, 9003",
    "10 0011 0002 04 00010002, 9002",
    "17 000a 0002 000a 0002 04 0009, 9703",
    "17 0000 0002 000a 0001 02 0009, 9702",
    "07, 8701",
    "2b 0e01, ab01",
  })
  void whatCannotBeIsRefusedWithItsException(String request, String answer) {
    assertEquals(answer, to(request));
  }

  @Test
  void requestsOfAnyBytesAreAnswered() {
    Random random = new Random(5);
    for (int i = 0; i < 20_000; i++) {
      byte[] request = new byte[random.nextInt(20)];
      random.nextBytes(request);
      if (request.length > 0 && random.nextInt(4) > 0) {
        request[0] = (byte) random.nextInt(24);
      }
      String answer = answers.to(new String(request, StandardCharsets.ISO_8859_1));
      assertTrue(answer.length() >= 2, () -> HexFormat.of().formatHex(request));
    }
  }

  @Test
  void connectionAnswersWhatComesInPieces() {
    ModbusUnit unit = new ModbusUnit(OptionalInt.of(3), memory);
    memory.set(ModbusTable.REGISTER, 10, 5);
    String two = bytes("0001 0000 0006 03 03 000a 0001" + "0002 0000 0006 04 03 000a 0001");
    String whole = "000100000005030302" + "0005" + "000200000003" + "04830b";
    for (int cut = 0; cut <= two.length(); cut++) {
      var talk = unit.connect();
      String answer = talk.hear(two.substring(0, cut)) + talk.hear(two.substring(cut));
      assertEquals(whole, hex(answer), "cut at " + cut);
    }
  }

  @Test
  void whatIsNoModbusIsDropped() {
    ModbusUnit unit = new ModbusUnit(OptionalInt.empty(), memory);
    var talk = unit.connect();
    assertEquals("", talk.hear("GET / HTTP/1.1\r\n\r\n"));
    assertEquals("", talk.hear(bytes("0001 0000 ffff 01")));
    assertEquals("000100000003018302", hex(talk.hear(bytes("0001 0000 0006 01 03 0000 0001"))));
  }
}
