package org.pendant.protocols.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.net.ProtocolException;

class ScriptFramerTest {
  private static final String BLINK =
      "def blink():\n  if True:\n    set_digital_out(0, True)\n  end\nend\n";

  private final TextBudget budget = new TextBudget();
  private final ScriptFramer framer = new ScriptFramer(budget);

  private static ByteBuffer bytes(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private List<ScriptItem> items(String text) throws ProtocolException {
    return framer.all(bytes(text));
  }

  private static ScriptItem program(String text) {
    return new ScriptItem.Program(text);
  }

  private static ScriptItem line(String text) {
    return new ScriptItem.Line(text);
  }

  @Test
  void aProgramEndsWithEndInTheFirstColumn() throws Exception {
    assertEquals(List.of(program(BLINK)), items(BLINK));
  }

  @Test
  void aSecondaryProgramIsOneToo() throws Exception {
    String text = "sec s():\n set_digital_out(0, True)\nend\n";
    assertEquals(List.of(program(text)), items(text));
  }

  @Test
  void theLastLineEndIsWaitedFor() throws Exception {
    String unfinished = BLINK.substring(0, BLINK.length() - 1);
    assertEquals(List.of(), items(unfinished));
    assertEquals(unfinished.length(), framer.unfinished());
    assertEquals(List.of(program(BLINK)), items("\n"));
    assertEquals(0, framer.unfinished());
  }

  @Test
  void otherLinesStandForThemselves() throws Exception {
    assertEquals(
        List.of(line("stop program"), program(BLINK), line("movej([0,0,0,0,0,0])")),
        items("stop program\n" + BLINK + "movej([0,0,0,0,0,0])\n"));
  }

  @Test
  void blankLinesAndCommentsBetweenProgramsSayNothing() throws Exception {
    assertEquals(
        List.of(program(BLINK)), items("\n  \r\n# a comment\n   # another\n" + BLINK + "\n"));
  }

  @Test
  void carriageReturnsInFrontOfLineEndsAreTolerated() throws Exception {
    String text = "def p():\r\n  sync()\r\nend\r\n";
    assertEquals(List.of(line("power on"), program(text)), items("power on\r\n" + text));
  }

  @Test
  void endMayHaveACommentBehindIt() throws Exception {
    String text = "def p():\n  sync()\nend # of p\n";
    assertEquals(List.of(program(text)), items(text));
  }

  @Test
  void longerWordsAreNeitherBeginNorEnd() throws Exception {
    String text = "def p():\n  sync()\nend_x = 1\nend\u00e9 = 1\nending = 2\nend\n";
    assertEquals(
        List.of(line("define = 3"), line("sector(1)"), program(text)),
        items("define = 3\nsector(1)\n" + text));
  }

  @Test
  void anIndentedBeginIsALine() throws Exception {
    assertEquals(List.of(line(" def p():")), items(" def p():\n"));
  }

  @Test
  void itDoesNotMatterWhereTheBytesAreCut() throws Exception {
    String text = "power on\r\n" + BLINK + "\nset speed 0.5\n" + BLINK + "x\n";
    List<ScriptItem> whole = items(text);
    assertEquals(5, whole.size());
    for (int cut = 0; cut <= text.length(); cut++) {
      ScriptFramer other = new ScriptFramer(budget);
      List<ScriptItem> found = new ArrayList<>(other.all(bytes(text.substring(0, cut))));
      found.addAll(other.all(bytes(text.substring(cut))));
      assertEquals(whole, found, "cut at " + cut);
    }
  }

  @Test
  void randomBytesInRandomPiecesComeOutTheSame() throws Exception {
    for (long seed = 0; seed < 300; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      String text = randomText(random);
      List<ScriptItem> whole = new ScriptFramer(budget).all(bytes(text));
      ScriptFramer other = new ScriptFramer(budget);
      List<ScriptItem> found = new ArrayList<>();
      int at = 0;
      while (at < text.length()) {
        int next = Math.min(text.length(), at + random.nextInt(7));
        found.addAll(other.all(bytes(text.substring(at, next))));
        at = next;
      }
      assertEquals(whole, found, "seed " + seed);
      other.close();
    }
  }

  private static String randomText(SplittableRandom random) {
    String[] pieces = {"def ", "sec ", "end", "\n", "\n", "\r", " ", "x", "#", "\u00ff", "\0", "_"};
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 200; i++) {
      text.append(pieces[random.nextInt(pieces.length)]);
    }
    return text.toString();
  }

  @Test
  void aTextWithoutEndIsRefusedAtSixteenMegabytes() throws Exception {
    assertEquals(List.of(), items("def p():\n"));
    String block = " ".repeat(1 << 20);
    ProtocolException refused =
        assertThrows(
            ProtocolException.class,
            () -> {
              for (int i = 0; i <= 16; i++) {
                framer.all(bytes(block));
              }
            });
    assertEquals("a script is longer than 16 MB, the most that is taken", refused.getMessage());
  }

  @Test
  void allClientsTogetherAreBounded() throws Exception {
    List<ScriptFramer> clients = new ArrayList<>();
    byte[] most = new byte[ScriptFramer.MAX_BYTES];
    for (int i = 0; i < TextBudget.CAPACITY / ScriptFramer.MAX_BYTES; i++) {
      ScriptFramer client = new ScriptFramer(budget);
      clients.add(client);
      assertEquals(List.of(), client.all(ByteBuffer.wrap(most)));
    }
    ProtocolException refused = assertThrows(ProtocolException.class, () -> framer.all(bytes("x")));
    assertTrue(refused.getMessage().contains("64 MB"), refused.getMessage());
    clients.getFirst().close();
    assertEquals(List.of(line("x")), items("x\n"));
  }
}
