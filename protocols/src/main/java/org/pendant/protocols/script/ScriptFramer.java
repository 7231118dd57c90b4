package org.pendant.protocols.script;

import static org.pendant.protocols.script.ReceivedScriptTexts.text;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.protocols.net.ProtocolException;

/**
 * Script framing: cuts the bytes of one client into programs and lines by the column rule (manual
 * 2): a program begins with {@code def} or {@code sec} in the first column and ends with {@code
 * end} there; outside of programs every line stands for itself. Blank lines and comments outside of
 * programs say nothing.
 */
final class ScriptFramer implements AutoCloseable {
  /** Bytes of the longest program or line. */
  static final int MAX_BYTES = 16 << 20;

  private static final int FIRST_BYTES = 1 << 12;
  private static final byte[] DEF = word("def");
  private static final byte[] SEC = word("sec");
  private static final byte[] END = word("end");

  private final TextBudget budget;
  private byte[] text = new byte[0];
  private int length;
  private int lineStart;
  private boolean inProgram;

  /** A client that has sent nothing yet. */
  ScriptFramer(TextBudget budget) {
    this.budget = budget;
  }

  private static byte[] word(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * Takes what has come, cut anywhere, up to the next item; empty when all bytes are used up.
   *
   * @throws ProtocolException if a text grows beyond what there is room for
   */
  Optional<ScriptItem> next(ByteBuffer bytes) throws ProtocolException {
    while (bytes.hasRemaining()) {
      byte next = bytes.get();
      append(next);
      if (next == '\n') {
        Optional<ScriptItem> item = endLine();
        if (item.isPresent()) {
          return item;
        }
      }
    }
    return Optional.empty();
  }

  /** All items that {@link #next} finds in {@code bytes}. */
  List<ScriptItem> all(ByteBuffer bytes) throws ProtocolException {
    List<ScriptItem> items = new ArrayList<>();
    for (Optional<ScriptItem> item = next(bytes); item.isPresent(); item = next(bytes)) {
      items.add(item.get());
    }
    return items;
  }

  /** How many bytes of an unfinished text wait for their end. */
  int unfinished() {
    return length;
  }

  private void append(byte next) throws ProtocolException {
    if (length == text.length) {
      grow();
    }
    text[length++] = next;
  }

  private void grow() throws ProtocolException {
    int wanted = Math.min(MAX_BYTES, Math.max(FIRST_BYTES, text.length * 2));
    if (wanted <= text.length) {
      close();
      throw new ProtocolException(text("scriptTooLong", MAX_BYTES >> 20));
    }
    if (!budget.take(wanted - text.length)) {
      close();
      throw new ProtocolException(text("unfinishedScriptsTooLong", TextBudget.CAPACITY >> 20));
    }
    text = Arrays.copyOf(text, wanted);
  }

  /** The last byte ends a line; it may end an item as well. */
  private Optional<ScriptItem> endLine() {
    if (!inProgram) {
      inProgram = lineBegins(DEF) || lineBegins(SEC);
      return inProgram ? nextLine() : finishLine();
    }
    return lineBegins(END) ? Optional.of(new ScriptItem.Program(take(length))) : nextLine();
  }

  private Optional<ScriptItem> nextLine() {
    lineStart = length;
    return Optional.empty();
  }

  private Optional<ScriptItem> finishLine() {
    int end = length - 1;
    while (end > 0 && text[end - 1] == '\r') {
      end--;
    }
    String line = take(end);
    return line.isBlank() || line.stripLeading().startsWith("#")
        ? Optional.empty()
        : Optional.of(new ScriptItem.Line(line));
  }

  /** Whether the last line begins with {@code word} in its first column, and no longer word. */
  private boolean lineBegins(byte[] word) {
    int after = lineStart + word.length;
    if (after >= length || !Arrays.equals(text, lineStart, after, word, 0, word.length)) {
      return false;
    }
    byte next = text[after];
    return !(Character.isLetterOrDigit(next & 0x7F) || next == '_' || next < 0);
  }

  /** The first {@code end} bytes; the text is empty then. */
  private String take(int end) {
    String taken = new String(text, 0, end, StandardCharsets.ISO_8859_1);
    length = 0;
    lineStart = 0;
    inProgram = false;
    if (text.length > FIRST_BYTES) {
      close();
    }
    return taken;
  }

  /** Gives back the room; what is unfinished is lost. */
  @Override
  public void close() {
    budget.giveBack(text.length);
    text = new byte[0];
    length = 0;
    lineStart = 0;
    inProgram = false;
  }
}
