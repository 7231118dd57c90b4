package org.pendant.gui.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.function.Consumer;

/** What becomes of our own mistakes: the window tells of them, a file has all there is to know. */
final class Faults {
  private Faults() {}

  /** From now on, faults of all threads are told and written to the end of {@code file}. */
  static void tellTo(Consumer<String> tell, Path file) {
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, fault) -> {
          String written = write(thread, fault, file);
          EventQueue.invokeLater(() -> tell.accept("Internal error: " + fault + "; " + written));
        });
  }

  private static String write(Thread thread, Throwable fault, Path file) {
    StringWriter details = new StringWriter();
    PrintWriter out = new PrintWriter(details);
    out.println(Instant.now() + " thread " + thread.getName());
    for (Throwable each = fault; each != null; each = each.getCause()) {
      out.println(each);
      for (StackTraceElement element : each.getStackTrace()) {
        out.println("    at " + element);
      }
    }
    try {
      Files.createDirectories(file.getParent());
      Files.writeString(
          file, details.toString(), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      return "please report it with " + file;
    } catch (IOException e) {
      return file + " cannot be written: " + e.getMessage();
    }
  }
}
