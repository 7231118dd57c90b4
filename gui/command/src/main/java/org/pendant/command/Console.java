package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import org.pendant.command.text.CommandLanguage;
import org.pendant.language.source.VisibleText;

/**
 * Console: standard output and standard error of the process.
 *
 * <p>Script text is bytes, held one {@code char} a byte; it goes out as those bytes, whatever the
 * locale. Output is buffered; {@link #flush} is called where the process waits or ends. A reader
 * that has gone away ({@code | head -1}) is no error: {@link #outputClosed} tells, and further
 * lines are dropped. Several threads may write: a line is never torn.
 */
final class Console {
  private static final int BUFFER_BYTES = 1 << 16;

  private final OutputStream output;
  private final PrintStream errors;
  private boolean outputClosed;

  Console(OutputStream output, OutputStream errors) {
    this.output = new BufferedOutputStream(output, BUFFER_BYTES);
    // A PrintStream forgives: complaints that cannot be read change nothing about the work.
    this.errors = new PrintStream(errors, false, StandardCharsets.UTF_8);
  }

  /** The streams this process was started with. */
  static Console ofProcess() {
    return new Console(
        new FileOutputStream(FileDescriptor.out), new FileOutputStream(FileDescriptor.err));
  }

  /** A console whose standard output is the standard error of this one. */
  Console toErrors() {
    return new Console(errors, errors);
  }

  /** A console with the standard error of this one, whose standard output nobody sees. */
  Console withoutOutput() {
    return new Console(OutputStream.nullOutputStream(), errors);
  }

  /** Writes {@code bytes}, one {@code char} a byte, and a line end to standard output. */
  synchronized void printBytes(String bytes) {
    write(bytes.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Writes {@code text} and a line end to standard output, as UTF-8 that only shows. */
  synchronized void print(String text) {
    write(VisibleText.of(text).getBytes(StandardCharsets.UTF_8));
  }

  /** Writes text to standard output as it is: it holds nothing that others chose unseen. */
  synchronized void printPiece(String text) {
    if (outputClosed) {
      return;
    }
    try {
      output.write(text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      outputFailed(e);
    }
  }

  private void write(byte[] line) {
    if (outputClosed) {
      return;
    }
    try {
      output.write(line);
      output.write('\n');
    } catch (IOException e) {
      outputFailed(e);
    }
  }

  /**
   * Writes one message and a line end to standard error, whatever its text comes from: it cannot
   * act on a terminal and cannot look like two messages. Pending output goes first, so that both
   * streams on one terminal read in the order of writing.
   */
  synchronized void complain(String text) {
    writeError(VisibleText.message(text));
  }

  /** The same with what others have said in English, in the language of the command line. */
  void complainFromEnglish(String text) {
    complain(CommandLanguage.shown(text));
  }

  /** The same with a text of lines that are laid out already, such as a {@link Report}. */
  synchronized void complainInLines(String text) {
    writeError(VisibleText.of(text));
  }

  /**
   * Tells of a fault in Pendant itself, with its stack.
   *
   * @param who works on in spite of it, such as {@code pendant rpc}
   */
  void complainOf(String who, Throwable fault) {
    StringWriter details = new StringWriter();
    fault.printStackTrace(new PrintWriter(details, true));
    complain(text("internalErrorOf", who, fault));
    complainInLines(details.toString().stripTrailing());
  }

  private void writeError(String text) {
    flush();
    errors.print(text);
    errors.print('\n');
    errors.flush();
  }

  /** Hands everything written so far to the readers. */
  synchronized void flush() {
    if (outputClosed) {
      return;
    }
    try {
      output.flush();
    } catch (IOException e) {
      outputFailed(e);
    }
  }

  /** The caller of {@link #outputClosed} ends the work. A reader that went away needs no words. */
  private void outputFailed(IOException cause) {
    outputClosed = true;
    String reason = String.valueOf(cause.getMessage());
    if (!reason.contains("pipe") && !reason.contains("Bad file descriptor")) {
      complain(text("outputCannotBeWritten", reason));
    }
  }

  /** Whether standard output turned out to have no reader any more. */
  synchronized boolean outputClosed() {
    return outputClosed;
  }
}
