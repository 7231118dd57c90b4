package org.pendant.editors.wire;

import java.util.function.Consumer;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/**
 * Protocol log: what LSP4J logs, one line each and without stack traces. For a process that is an
 * editor's server: loggers belong to the process.
 */
public final class ProtocolLog implements AutoCloseable {
  private static final String NAME = "org.eclipse.lsp4j";

  // Loggers that nobody holds are made anew, and forget how they were set.
  private final Logger logger = Logger.getLogger(NAME);
  private final Handler handler;

  /** Has {@code lines} told of what cannot be read or sent, until it is closed. */
  public ProtocolLog(Consumer<String> lines) {
    handler =
        new Handler() {
          @Override
          public void publish(LogRecord entry) {
            if (entry.getLevel().intValue() >= Level.SEVERE.intValue()) {
              lines.accept(firstLine(String.valueOf(entry.getMessage())));
            }
          }

          @Override
          public void flush() {}

          @Override
          public void close() {}
        };
    logger.addHandler(handler);
    logger.setUseParentHandlers(false);
  }

  private static String firstLine(String text) {
    return text.lines().findFirst().orElse("");
  }

  @Override
  public void close() {
    logger.removeHandler(handler);
    logger.setUseParentHandlers(true);
  }
}
