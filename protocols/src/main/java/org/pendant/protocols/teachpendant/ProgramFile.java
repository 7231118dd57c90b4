package org.pendant.protocols.teachpendant;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.urp.UrpxPrograms;

/**
 * Program file of the programs folder.
 *
 * @param name of the file
 * @param created when it was made, as far as the file system knows
 * @param modified when it was written last
 */
public record ProgramFile(String name, Instant created, Instant modified) {
  /** Endings of programs; of two files with one name the first of these is meant. */
  static final List<String> ENDINGS =
      Stream.concat(TreeFile.ENDINGS.stream(), Stream.of(TreeFile.SCRIPT, UrpxPrograms.ENDING))
          .toList();

  /** Whether a file is called as programs are. */
  static boolean isProgram(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return ENDINGS.stream().anyMatch(lower::endsWith);
  }

  /** By name; of those with one name the one that is meant comes first. */
  static final Comparator<ProgramFile> ORDER =
      Comparator.comparing((ProgramFile file) -> bareName(file.name))
          .thenComparingInt(ProgramFile::rank);

  private int rank() {
    return ENDINGS.indexOf(name.substring(name.lastIndexOf('.')).toLowerCase(Locale.ROOT));
  }

  /** The name of a file without the ending of programs. */
  public static String bareName(String name) {
    return isProgram(name) ? name.substring(0, name.lastIndexOf('.')) : name;
  }
}
