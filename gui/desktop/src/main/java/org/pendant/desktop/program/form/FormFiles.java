package org.pendant.desktop.program.form;

import java.nio.file.Path;
import java.util.function.Consumer;

/** Form files: chooses and reads files for forms. */
interface FormFiles {

  /** Asks for a file; {@code chosen} hears of it unless none is chosen. */
  void choose(String title, String ending, Consumer<Path> chosen);

  /**
   * Reads a text, not on the dispatch thread; the answer comes on it.
   *
   * @param failed told why it cannot be read
   */
  void read(Path file, Consumer<String> text, Consumer<String> failed);
}
