package org.pendant.controller.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.script.value.Value;

class SocketReadTest {
  private static final SocketRead MESSAGE = new SocketRead.Text(">", "<");

  private static void say(ReceivedBytes in, String bytes) throws InterruptedException {
    in.append(bytes.getBytes(StandardCharsets.ISO_8859_1), bytes.length());
  }

  private static ReceivedBytes received(String bytes) throws InterruptedException {
    ReceivedBytes in = new ReceivedBytes();
    say(in, bytes);
    return in;
  }

  private static String rest(ReceivedBytes in) {
    return in.text(0, in.length());
  }

  private static void reads(String expected, String rest, SocketRead read, String bytes)
      throws InterruptedException {
    ReceivedBytes in = received(bytes);
    assertEquals(Optional.of(expected), read.from(in).map(Value::text), bytes);
    assertEquals(rest, rest(in), bytes);
  }

  private static void waits(String rest, SocketRead read, String bytes)
      throws InterruptedException {
    ReceivedBytes in = received(bytes);
    assertEquals(Optional.empty(), read.from(in), bytes);
    assertEquals(rest, rest(in), bytes);
  }

  @Test
  void keepsWhatFollowsTheSuffixAndDropsWhatPrecedesThePrefix() throws InterruptedException {
    reads("hello", ">world<", MESSAGE, "noise>hello<>world<");
    reads("", "x", MESSAGE, "><x");
  }

  @Test
  void keepsAMessageThatIsNotComplete() throws InterruptedException {
    waits(">hel", MESSAGE, "x>hel");
    waits("", MESSAGE, "xyz");
    waits("<", new SocketRead.Text("<<", ">>"), "abc<");
  }

  @Test
  void readsAllWithoutASuffix() throws InterruptedException {
    reads("abc", "", new SocketRead.Text("", ""), "abc");
    reads("bc", "", new SocketRead.Text("a", ""), "xabc");
    waits("a", new SocketRead.Text("a", ""), "xa");
    waits("", new SocketRead.Text("", ""), "");
  }

  @Test
  void aTextHasAtMost1024Characters() throws InterruptedException {
    String long1024 = "x".repeat(1024);
    reads(long1024, "yz", new SocketRead.Text("", ""), long1024 + "yz");
    reads("x".repeat(1023), "y", new SocketRead.Text("", ";"), "x".repeat(1023) + ";y");
    reads("", ";y", new SocketRead.Text("", ";"), long1024 + ";y");
  }

  @Test
  void readsALineOfEitherKind() throws InterruptedException {
    reads("one", "two\n", new SocketRead.Line(), "one\r\ntwo\n");
    reads("one", "two\n", new SocketRead.Line(), "one\ntwo\n");
    reads("", "", new SocketRead.Line(), "\n");
    waits("one\r", new SocketRead.Line(), "one\r");
  }

  @Test
  void readsFloatsWithTheirCount() throws InterruptedException {
    reads(
        "[4, 1.414, 3.14159, 1.616, 0]",
        "",
        new SocketRead.Floats(4),
        "( 1.414 , 3.14159, 1.616, 0.0)");
    reads("[3, -0.5, 200, 7]", "(1)", new SocketRead.Floats(3), "x(-.5,2e2,+7.)(1)");
  }

  @Test
  void fewerFloatsLeaveTheRestUnknownAndMoreAreDropped() throws InterruptedException {
    reads("[2, 1, 2, nan]", "", new SocketRead.Floats(3), "(1,2)");
    reads("[1, 1]", "", new SocketRead.Floats(1), "(1,2,3)");
  }

  @Test
  void whatIsNoFloatFails() throws InterruptedException {
    for (String wrong : List.of("()", "(1,,2)", "(1 2)", "(1d,2)", "(0x1p3,1)", "(one)", "((1)")) {
      reads("[0, nan, nan]", "", new SocketRead.Floats(2), wrong);
    }
  }

  @Test
  void readsBigEndianIntegers() throws InterruptedException {
    reads(
        "[3, 1, -1, -2147483648]",
        "z",
        new SocketRead.Binary(3, 4),
        "\0\0\0\1\u00ff\u00ff\u00ff\u00ff\u0080\0\0\0z");
    waits("\0\0\0\1\0", new SocketRead.Binary(2, 4), "\0\0\0\1\0");
  }

  @Test
  void readsBytes() throws InterruptedException {
    reads("[3, 100, 200, 0]", "a", new SocketRead.Binary(3, 1), "d\u00c8\0a");
    waits("d", new SocketRead.Binary(3, 1), "d");
  }

  @Test
  void failuresAnswerAsTheManualSays() {
    assertEquals("[0, nan, nan]", new SocketRead.Floats(2).failed().text());
    assertEquals("[0, -1, -1]", new SocketRead.Binary(2, 4).failed().text());
    assertEquals("", MESSAGE.failed().text());
    assertEquals("", new SocketRead.Line().failed().text());
    assertEquals("0", new SocketRead.Variable("x").failed().text());
  }

  @Test
  void findsItsVariableAmongOtherLines() throws InterruptedException {
    reads("42", "rest", new SocketRead.Variable("POS_X"), "hello\nPOS_XY 1\nPOS_X 42\r\nrest");
    reads("-7", "", new SocketRead.Variable("a"), "a 1.5\na 99999999999\na -7\n");
    waits("a 1", new SocketRead.Variable("a"), "a 1");
  }

  /** However a message is cut, the outcome is that of the whole. */
  @Test
  void cutsMakeNoDifference() throws InterruptedException {
    SplittableRandom random = new SplittableRandom(7);
    List<SocketRead> reads =
        List.of(
            MESSAGE,
            new SocketRead.Text("ab", "ba"),
            new SocketRead.Line(),
            new SocketRead.Floats(3),
            new SocketRead.Binary(2, 4),
            new SocketRead.Variable("a"));
    for (int round = 0; round < 2000; round++) {
      String text = randomText(random);
      for (SocketRead read : reads) {
        List<String> whole = all(read, received(text));
        ReceivedBytes in = new ReceivedBytes();
        List<String> pieces = new ArrayList<>();
        for (int i = 0; i < text.length(); i++) {
          say(in, text.substring(i, i + 1));
          pieces.addAll(all(read, in));
        }
        assertEquals(whole, pieces, () -> read + " of " + text);
      }
    }
  }

  private static String randomText(SplittableRandom random) {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(30); i > 0; i--) {
      text.append("ab<>(),12. \r\n".charAt(random.nextInt(13)));
    }
    return text.toString();
  }

  private static List<String> all(SocketRead read, ReceivedBytes in) {
    List<String> values = new ArrayList<>();
    for (Optional<Value> value = read.from(in); value.isPresent(); value = read.from(in)) {
      values.add(value.get().text());
    }
    return values;
  }
}
