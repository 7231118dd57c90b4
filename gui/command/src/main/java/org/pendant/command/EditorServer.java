package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.OptionalInt;
import org.pendant.editors.wire.LoopbackListener;
import org.pendant.editors.wire.ProtocolLog;

/**
 * Editor server: serves the one editor at standard input and output, or those that connect to a
 * port of this computer; what {@code pendant lsp} and {@code pendant dap} have in common.
 */
final class EditorServer {
  private final String command;
  private final InputStream input;
  private final OutputStream output;

  /** One session with one editor. */
  @FunctionalInterface
  interface Session {
    /**
     * Serves the editor until it leaves.
     *
     * @return whether it has left as the protocol wants it
     * @throws InterruptedException if the thread is interrupted
     */
    boolean serve(InputStream in, OutputStream out) throws InterruptedException;
  }

  /**
   * A server for a command.
   *
   * @param command its name, for messages
   */
  EditorServer(String command, InputStream input, OutputStream output) {
    this.command = command;
    this.input = input;
    this.output = output;
  }

  /** Serves until the editor has left, or for ever at a port. */
  ExitCode run(OptionalInt port, Console console, Session session) throws UsageException {
    try (ProtocolLog _ =
        new ProtocolLog(line -> console.complain("pendant " + command + ": " + line))) {
      if (port.isPresent()) {
        return listen(port.getAsInt(), console, session);
      }
      return session.serve(input, output) ? ExitCode.DONE : ExitCode.PROGRAM_FAILED;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCode.DONE;
    }
  }

  private ExitCode listen(int port, Console console, Session session) throws UsageException {
    try (LoopbackListener listener = new LoopbackListener(port)) {
      console.complain(text("listening", command, listener.port()));
      listener.serve(session::serve);
      return ExitCode.DONE;
    } catch (IOException e) {
      throw new UsageException(text("portCannotBeOpened", port, e.getMessage()));
    }
  }
}
