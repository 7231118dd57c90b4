package org.pendant.kit.export;

import java.io.IOException;
import java.nio.file.Path;

/** Export: writes something to a file; runs outside of the dispatch thread. */
@FunctionalInterface
public interface Export {
  /** Creates the file, or replaces it when all of the new one is there. */
  void writeTo(Path file) throws IOException;
}
