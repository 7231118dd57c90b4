package org.pendant.desktop.help;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Texts that are packaged with the program. */
public final class HelpTexts {
  private HelpTexts() {}

  /**
   * One that is always there.
   *
   * @param name where it is beside this class
   * @throws IllegalStateException if it is missing, an internal error
   */
  public static String read(String name) {
    return find(name)
        .orElseThrow(() -> new IllegalStateException("resource " + name + " is missing"));
  }

  /**
   * A file that is always there, as it is.
   *
   * @param name where it is beside this class
   * @throws IllegalStateException if it is missing, an internal error
   */
  static byte[] bytes(String name) {
    try (InputStream in = HelpTexts.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("resource " + name + " is missing");
      }
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException("resource " + name, e);
    }
  }

  /** One that only a packaged program has, such as {@code /NOTICE}. */
  static Optional<String> find(String name) {
    try (InputStream in = HelpTexts.class.getResourceAsStream(name)) {
      return in == null
          ? Optional.empty()
          : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("resource " + name, e);
    }
  }
}
