package org.pendant.protocols.toolserial;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolCommunication.Parity;
import org.pendant.controller.external.ToolSerialConnector;

@Timeout(30)
@Tag("slow")
class ToolSerialLineTest {
  private static final ToolCommunication ON =
      new ToolCommunication(true, 115200, Parity.NONE, 1, 1.5f, 3.5f);

  @TempDir Path folder;

  /** A peer on the line. */
  private static final class Member {
    private final ToolSerialLine line;
    private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private final Consumer<byte[]> hears = this::note;

    Member(ToolSerialLine line) {
      this.line = line;
      line.join(hears);
    }

    private void note(byte[] bytes) {
      heard.add(new String(bytes, StandardCharsets.ISO_8859_1));
    }

    void say(String text) {
      line.send(hears, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** The next characters that it hears, in however many pieces they come. */
    String hear(int count) throws InterruptedException {
      StringBuilder text = new StringBuilder();
      while (text.length() < count) {
        text.append(heard.poll(20, TimeUnit.SECONDS));
      }
      return text.toString();
    }
  }

  private static void setUp(ToolSerialLine line, ToolCommunication wanted) {
    ToolSerialConnector.SetUp setUp = line.setUp(wanted);
    while (!setUp.over()) {
      Thread.onSpinWait();
    }
  }

  private static void turnOff(ToolSerialLine line) {
    setUp(line, ToolCommunication.STANDARD);
  }

  /** The next thing that the line has to say. */
  private static ToolSerialConnector.News news(ToolSerialLine line) {
    List<ToolSerialConnector.News> news = line.takeNews();
    while (news.isEmpty()) {
      LockSupport.parkNanos(1_000_000);
      news = line.takeNews();
    }
    return news.getFirst();
  }

  private static void assertTrouble(ToolSerialLine line, String text) {
    assertEquals(new ToolSerialConnector.News(true, "tool communication: " + text), news(line));
  }

  @Test
  void allOthersHearWhatOneSends() throws Exception {
    try (ToolSerialLine line = new ToolSerialLine()) {
      setUp(line, ON);
      Member one = new Member(line);
      Member two = new Member(line);
      Member three = new Member(line);
      one.say("ping");
      two.say("pong");
      assertEquals("pong", one.hear(4));
      assertEquals("ping", two.hear(4));
      assertEquals("pingpong", three.hear(8));
      assertNull(one.heard.poll());
      assertNull(two.heard.poll());
    }
  }

  @Test
  void whatIsSentWhileItIsOffIsLostAndSaidOnce() throws Exception {
    try (ToolSerialLine line = new ToolSerialLine()) {
      Member one = new Member(line);
      Member two = new Member(line);
      one.say("lost");
      one.say("lost too");
      setUp(line, ON);
      one.say("heard");
      assertEquals("heard", two.hear(5));
      assertTrouble(
          line, "it is off, so what clients send is lost; set_tool_communication turns it on");
      assertEquals(List.of(), line.takeNews());
    }
  }

  @Test
  void aDeviceHearsAndIsHeard() throws Exception {
    try (PseudoTerminals cable = PseudoTerminals.in(folder);
        ToolSerialLine line = ToolSerialLine.to(cable.box())) {
      setUp(line, ON);
      assertEquals(List.of(), line.takeNews());
      Member one = new Member(line);
      byte[] all = new byte[256];
      for (int i = 0; i < all.length; i++) {
        all[i] = (byte) i;
      }
      String text = new String(all, StandardCharsets.ISO_8859_1);
      one.say(text);
      assertArrayEquals(all, cable.heard(256));
      cable.say(all);
      assertEquals(text, one.hear(256));
    }
  }

  @Test
  void theDeviceIsLeftAloneWhileTheLineIsOff() throws Exception {
    try (PseudoTerminals cable = PseudoTerminals.in(folder);
        ToolSerialLine line = ToolSerialLine.to(cable.box());
        ToolSerialLine other = ToolSerialLine.to(cable.box())) {
      setUp(line, ON);
      setUp(other, ON);
      assertTrouble(other, cable.box() + " is used by another program, or is no serial device");
      turnOff(line);
      assertEquals(
          new ToolSerialConnector.News(false, "tool communication: the serial device is there now"),
          news(other));
    }
  }

  @Test
  void aDeviceThatIsNotThereIsTakenWhenItComes() throws Exception {
    Path missing = folder.resolve("box");
    try (ToolSerialLine line = ToolSerialLine.to(missing.toString())) {
      setUp(line, ON);
      assertTrouble(line, "there is no " + missing);
      try (PseudoTerminals cable = PseudoTerminals.in(folder)) {
        assertEquals("tool communication: the serial device is there now", news(line).text());
        Member one = new Member(line);
        cable.say((byte) 'x');
        assertEquals("x", one.hear(1));
      }
    }
  }

  @Test
  void aDeviceThatVanishesIsMissedAndTheOthersGoOn() throws Exception {
    PseudoTerminals cable = PseudoTerminals.in(folder);
    try (cable;
        ToolSerialLine line = ToolSerialLine.to(cable.box())) {
      setUp(line, ON);
      cable.close();
      assertTrouble(line, "the serial device is gone; it is looked for every second");
      Member one = new Member(line);
      Member two = new Member(line);
      one.say("still here");
      assertEquals("still here", two.hear(10));
    }
  }

  @Test
  void whatIsNoSerialDeviceIsRefused() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "text");
    try (ToolSerialLine line = ToolSerialLine.to(file.toString())) {
      setUp(line, ON);
      assertTrouble(line, file + " is used by another program, or is no serial device");
      assertEquals("text", Files.readString(file));
    }
  }

  @Test
  void aDeviceWithoutPermissionIsSaidToBeOne() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));
    Assumptions.assumeTrue(
        file.toFile().setReadable(false) && !Files.isReadable(file),
        "skipped: this user may read everything");
    try (ToolSerialLine line = ToolSerialLine.to(file.toString())) {
      setUp(line, ON);
      assertTrouble(line, "no permission to read and write " + file);
    }
  }

  @Test
  void aToolThatReadsNothingHoldsNobodyWhenTheLineIsClosed() throws Exception {
    try (PseudoTerminals cable = PseudoTerminals.in(folder)) {
      ToolSerialLine line = ToolSerialLine.to(cable.box());
      setUp(line, ON);
      Member one = new Member(line);
      Member two = new Member(line);
      one.say("x".repeat(1 << 20));
      assertEquals('x', two.hear(1).charAt(0));
      for (int i = 0; i < 4; i++) {
        one.say("x".repeat(1 << 14));
      }
      line.close();
      one.say("too late");
      assertNull(two.heard.poll());
    }
  }

  @Test
  void speedParityAndStopBitsReachTheDevice() {
    assertEquals(SerialPort.NO_PARITY, ComPort.parity(Parity.NONE));
    assertEquals(SerialPort.ODD_PARITY, ComPort.parity(Parity.ODD));
    assertEquals(SerialPort.EVEN_PARITY, ComPort.parity(Parity.EVEN));
    assertEquals(SerialPort.ONE_STOP_BIT, ComPort.stopBits(ON));
    assertEquals(
        SerialPort.TWO_STOP_BITS,
        ComPort.stopBits(new ToolCommunication(true, 9600, Parity.ODD, 2, 1, 0)));
  }
}
