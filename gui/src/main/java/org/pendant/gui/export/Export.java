package org.pendant.gui.export;

import java.io.IOException;
import java.nio.file.Path;

/** Writes something to a file; runs outside of the dispatch thread. */
@FunctionalInterface
public interface Export {
  /** Creates or empties the file and fills it. */
  void writeTo(Path file) throws IOException;
}
