package org.pendant.protocols.modbus;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/** Questions and answers without the prefix: what stands here begins with the unit. */
class AnswersTest {
  private static final String CLIENT = "Modbus client 127.0.0.1:50001";

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final Answers answers =
      new Answers(new DirectBox(controller), new ReentrantReadWriteLock());

  /** Drives the controller itself. */
  private record DirectBox(Controller controller) implements Answers.Box {
    @Override
    public ControllerState state() {
      return controller.state();
    }

    @Override
    public void write(List<SignalWrite> writes) throws RefusedRequest {
      if (!(carryOut(controller, new IoCommand.WriteSignals(CLIENT, writes))
          instanceof Reply.Done)) {
        throw new RefusedRequest(Reason.FAILURE);
      }
    }
  }

  AnswersTest() {
    controller.advance();
  }

  private static Reply carryOut(Controller controller, Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    return reply.join();
  }

  private static byte[] frame(byte[] body) {
    return ByteBuffer.allocate(ModbusFrameReader.PREFIX + body.length)
        .putShort((short) 0x1234)
        .putShort((short) 0)
        .putShort((short) body.length)
        .put(body)
        .array();
  }

  private String ask(String body) {
    byte[] answer = answers.answer(frame(Hex.bytes(body)));
    ByteBuffer prefix = ByteBuffer.wrap(answer);
    assertEquals(0x1234, prefix.getShort());
    assertEquals(0, prefix.getShort());
    assertEquals(answer.length - ModbusFrameReader.PREFIX, prefix.getShort());
    return Hex.text(Arrays.copyOfRange(answer, ModbusFrameReader.PREFIX, answer.length));
  }

  private void assertAnswer(String expected, String question) {
    assertEquals(expected.replace(" ", ""), ask(question));
  }

  @Test
  void writesAndReadsAGeneralPurposeRegister() {
    assertAnswer("01 06 0080 04D2", "01 06 0080 04D2");
    assertAnswer("01 03 02 04D2", "01 03 0080 0001");
    assertAnswer("01 04 02 04D2", "01 04 0080 0001");
  }

  @Test
  void setsAnOutputByItsCoil() {
    assertAnswer("01 05 0010 FF00", "01 05 0010 FF00");
    assertTrue(controller.state().io().standardOut() == 1);
    assertAnswer("01 01 01 01", "01 01 0010 0001");
    assertAnswer("01 02 01 01", "01 02 0010 0001");
    assertAnswer("01 05 0010 0000", "01 05 0010 0000");
    assertAnswer("01 01 01 00", "01 01 0010 0001");
  }

  @Test
  void packsBitsLowestFirst() {
    // outputs 0, 2, 3 of the box and 1 of the tool
    assertAnswer("01 0F 0010 000A", "01 0F 0010 000A 02 0D02");
    assertAnswer("01 01 02 0D02", "01 01 0010 000A");
    assertAnswer("01 01 01 06", "01 01 0011 0003");
  }

  @Test
  void writesSeveralRegistersAtOnce() {
    assertAnswer("01 10 0080 0003", "01 10 0080 0003 06 0001 FFFF 8000");
    assertAnswer("01 03 06 0001 FFFF 8000", "01 03 0080 0003");
  }

  @Test
  void changesSomeBitsOfARegister() {
    // the example of the protocol, 6.16
    assertAnswer("01 06 0084 0012", "01 06 0084 0012");
    assertAnswer("01 16 0084 00F2 0025", "01 16 0084 00F2 0025");
    assertAnswer("01 03 02 0017", "01 03 0084 0001");
  }

  @Test
  void readsWhatTheSameRequestHasWritten() {
    assertAnswer("01 17 04 0000 0007", "01 17 0080 0002 0081 0001 02 0007");
  }

  @Test
  void writesNothingWhenWhatIsReadIsNotThere() {
    assertAnswer("01 97 02", "01 17 0030 0001 0080 0001 02 0007");
    assertAnswer("01 03 02 0000", "01 03 0080 0001");
  }

  @Test
  void setsAndClearsOutputsByMasks() {
    ask("01 06 0001 0081");
    assertAnswer("01 06 0002 0006", "01 06 0002 0006");
    assertAnswer("01 03 02 0087", "01 03 0001 0001");
    assertAnswer("01 06 0003 0081", "01 06 0003 0081");
    assertAnswer("01 03 02 0006", "01 03 0001 0001");
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 32, 33})
  void aMaskOfZeroChangesNothingAndIsNotRefused(int address) {
    String question = "01 06 %04X 0000".formatted(address);
    assertAnswer(question, question);
  }

  @Test
  void answersEveryUnitWithItsNumber() {
    assertAnswer("FF 03 02 0000", "FF 03 0080 0001");
    assertAnswer("00 03 02 0000", "00 03 0080 0001");
  }

  @ParameterizedTest
  @CsvSource({
    "00, 80", "07, 87", "08, 88", "0B, 8B", "11, 91", "14, 94", "18, 98", "2B, AB", "63, E3",
    "83, 83", "FF, FF"
  })
  void refusesFunctionsThatItDoesNotKnow(String function, String answered) {
    assertAnswer("01" + answered + "01", "01" + function);
    assertAnswer("01" + answered + "01", "01" + function + "0000 0001 0203");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "01 03 0022 0001", // behind the masks
        "01 03 007F 0002", // begins in a gap
        "01 03 0020 0003", // ends in a gap
        "01 04 FFFF 0001",
        "01 03 FFFF 0002", // beyond the last address
        "01 01 0030 0001",
        "01 02 002F 0002",
        "01 01 FFFF 0010"
      })
  void refusesToReadWhereThereIsNothing(String question) {
    int function = Integer.parseInt(question.substring(3, 5), 16);
    assertAnswer("01 %02X 02".formatted(function | 0x80), question);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "01 06 0000 0001", // inputs
        "01 06 0004 0000", // an analog input
        "01 06 0015 0000",
        "01 06 0100 0000", // the version
        "01 06 0102 0007", // the robot mode
        "01 06 010E 0000", // a joint angle
        "01 06 0022 0000", // nothing there
        "01 05 0000 FF00", // an input
        "01 05 0020 FF00",
        "01 05 0104 FF00", // whether the power is on
        "01 0F 000F 0002 01 03", // an input and an output
        "01 10 0080 0002 04 0001",
        "01 16 0000 0000 0000"
      })
  void refusesToWriteWhatCanOnlyBeRead(String question) {
    int function = Integer.parseInt(question.substring(3, 5), 16);
    boolean tooShort = question.equals("01 10 0080 0002 04 0001");
    assertAnswer("01 %02X %02X".formatted(function | 0x80, tooShort ? 3 : 2), question);
  }

  @Test
  void writesNothingWhenOneOfSeveralRegistersCanOnlyBeRead() {
    assertAnswer("01 90 02", "01 10 00FF 0002 04 0005 0005");
    assertAnswer("01 03 02 0000", "01 03 00FF 0001");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "01 03 0080 0000", // none
        "01 03 0080 007E", // 126, one too many
        "01 03 0080 00C8", // 200
        "01 03 0080 FFFF",
        "01 04 0080 0000",
        "01 01 0010 0000",
        "01 01 0010 07D1", // 2001
        "01 02 0010 07D1",
        "01 05 0010 1234", // neither on nor off
        "01 05 0010 0001",
        "01 05 0010 FF01",
        "01 0F 0010 0000 00",
        "01 0F 0010 0009 01 FF", // a byte too few
        "01 0F 0010 0008 02 FFFF", // a byte too many
        "01 10 0080 0000 00",
        "01 10 0080 0002 02 0001", // says two, brings one
        "01 10 0080 0001 03 000100",
        "01 17 0080 0000 0081 0001 02 0007",
        "01 17 0080 007E 0081 0001 02 0007",
        "01 17 0080 0001 0081 0000 00",
        "01 17 0080 0001 0081 0001 04 0007",
        "01 03 0080", // too short
        "01 03 0080 00",
        "01 03",
        "01 06 0080",
        "01 0F 0010",
        "01 10 0080 0001",
        "01 16 0080 0000",
        "01 17 0080 0001 0081 0001",
        "01 03 0080 0001 00", // too long
        "01 06 0080 0001 00",
        "01 16 0080 0000 0000 00",
        "01 06 0005 0002", // no domain
        "01 06 0014 000D" // the tool does not take 13 V
      })
  void refusesNumbersLengthsAndValuesThatCannotBe(String question) {
    int function = Integer.parseInt(question.substring(3, 5), 16);
    assertAnswer("01 %02X 03".formatted(function | 0x80), question);
  }

  @Test
  void readsAndWritesAsManyAsTheProtocolAllows() {
    assertEquals(2 * (3 + 250), ask("01 03 0080 007D").length());
    StringBuilder values = new StringBuilder();
    for (int i = 0; i < 123; i++) {
      values.append("%04X".formatted(i));
    }
    assertAnswer("01 10 0080 007B", "01 10 0080 007B F6" + values);
    assertAnswer("01 03 F6" + values, "01 03 0080 007B");
  }

  @Test
  void readsTheStateOfTheRobot() {
    // robot mode RUNNING, and a gap
    assertAnswer("01 03 02 0007", "01 03 0102 0001");
    assertAnswer("01 83 02", "01 03 0102 0002");
    // power on, no stop, no button
    assertAnswer("01 04 0C 0001 0000 0000 0000 0000 0000", "01 04 0104 0006");
    assertAnswer("01 01 01 01", "01 01 0104 0006");
    // the whole block of joint angles, as in the example of the reference
    assertTrue(ask("01 03 010E 0006").startsWith("01030C"));
    assertAnswer("01 83 02", "01 03 010E 0007");
  }

  @Test
  void failsWhenSomebodyElseHasTakenTheSignal() {
    assertEquals(
        new Reply.Done(),
        carryOut(
            controller,
            new IoCommand.ClaimSignal("RTDE client 127.0.0.1:50000", "digital_out[0]")));
    assertAnswer("01 85 04", "01 05 0010 FF00");
    // the first of both would be free
    assertAnswer("01 8F 04", "01 0F 0010 0002 01 03");
    assertEquals(0, controller.state().io().standardOut());
  }

  @Test
  void answersEverythingWithAWholeFrameOfTheSameFunction() {
    long seed = 502;
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      byte[] body =
          new byte
              [random.nextInt(
                  ModbusFrameReader.MIN_REST, i % 4 == 0 ? ModbusFrameReader.MAX_REST + 1 : 16)];
      random.nextBytes(body);
      if (i % 8 != 0) {
        body[1] = new byte[] {1, 2, 3, 4, 5, 6, 15, 16, 22, 23}[random.nextInt(10)];
      }
      byte[] frame = frame(body);
      String where = "seed " + seed + ": " + Hex.text(frame);
      byte[] answer = answers.answer(frame);
      assertEquals(
          answer.length - ModbusFrameReader.PREFIX, ByteBuffer.wrap(answer).getShort(4), where);
      assertEquals(body[0], answer[ModbusFrameReader.PREFIX], where);
      assertEquals(body[1] & 0x7F, answer[ModbusFrameReader.PREFIX + 1] & 0x7F, where);
    }
  }
}
