package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

final class ConsoleTest {

  /** A pipe whose reader has gone. */
  private static final class ClosedPipe extends OutputStream {
    @Override
    public void write(int b) throws IOException {
      throw new IOException("Broken pipe");
    }
  }

  @Test
  void messagesKeepTheirBytes() {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    Console console = new Console(output, new ByteArrayOutputStream());

    console.printBytes("\u00ff\u0000a");
    console.flush();

    assertArrayEquals(new byte[] {(byte) 0xff, 0, 'a', '\n'}, output.toByteArray());
  }

  @Test
  void outputGoesOutBeforeAComplaint() {
    ByteArrayOutputStream both = new ByteArrayOutputStream();
    Console console = new Console(both, both);

    console.print("first");
    console.complain("second");

    assertEquals("first\nsecond\n", both.toString(StandardCharsets.UTF_8));
  }

  @Test
  void lostReaderIsNoticedAndForgiven() {
    Console console = new Console(new ClosedPipe(), new ByteArrayOutputStream());

    console.print("a");
    assertFalse(console.outputClosed());
    console.flush();
    console.print("b");

    assertTrue(console.outputClosed());
  }

  @Test
  void complaintsCannotActOnATerminalNorLookLikeTwo() {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    Console console = new Console(new ByteArrayOutputStream(), errors);

    console.complain("popup: \u001b]0;owned\u0007\rerror\u009b2J\nt.script:1: error: fake");

    assertEquals(
        "popup: \\x1b]0;owned\\x07\\x0derror\\x9b2J\n    t.script:1: error: fake\n",
        errors.toString(StandardCharsets.UTF_8));
  }

  @Test
  void layoutOfOurOwnStays() {
    ByteArrayOutputStream both = new ByteArrayOutputStream();
    Console console = new Console(both, both);

    console.complainInLines("a.script:1:1: error: \u0007\nx\n^");
    console.print("port\u001b\t1");
    console.flush();

    assertEquals(
        "a.script:1:1: error: \\x07\nx\n^\nport\\x1b\t1\n", both.toString(StandardCharsets.UTF_8));
  }
}
