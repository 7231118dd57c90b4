package org.pendant.models.calibration;

import java.util.Map;
import org.pendant.models.json.FilePosition;

/** A piece of YAML, as far as {@link YamlReader} goes. */
sealed interface Yaml {
  /** Where it begins. */
  FilePosition place();

  /** A word or a number, without its quotes. */
  record Scalar(String text, FilePosition place) implements Yaml {}

  /** Entries in their order. */
  record Mapping(Map<String, Entry> entries, FilePosition place) implements Yaml {}

  /**
   * An entry of a mapping.
   *
   * @param place of its key
   */
  record Entry(FilePosition place, Yaml value) {}
}
