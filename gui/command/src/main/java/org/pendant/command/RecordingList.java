package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Recording list: a text with headings ({@code # ...}) and, below each, what follows {@code pendant
 * compare} on a command line. Files are in the folder of the list.
 */
record RecordingList(List<Entry> entries) {
  private static final String HEADING = "#";

  RecordingList {
    entries = List.copyOf(entries);
  }

  /**
   * A recording to be compared.
   *
   * @param heading what it is
   * @param line the words as they stand there
   * @param words the same, with the files as this process finds them
   */
  record Entry(String heading, String line, List<String> words) {
    Entry {
      words = List.copyOf(words);
    }
  }

  /**
   * Reads a list.
   *
   * @throws UsageException if it has nothing to compare, or something without a heading
   */
  static RecordingList of(String name, byte[] text) throws UsageException {
    Path parent = Path.of(name).getParent();
    Path folder = parent == null ? Path.of("") : parent;
    List<Entry> entries = new ArrayList<>();
    String heading = "";
    int number = 0;
    for (String line : new String(text, StandardCharsets.UTF_8).lines().toList()) {
      number++;
      if (line.startsWith(HEADING)) {
        heading = line.substring(1).strip();
      } else if (!line.isBlank()) {
        List<String> words = new ArrayList<>(Arrays.asList(line.strip().split("\\s+")));
        if (heading.isEmpty() || words.size() < 2) {
          throw new UsageException(text("headingExpected", name, number, line));
        }
        for (int i = words.size() - 2; i < words.size(); i++) {
          words.set(i, folder.resolve(words.get(i)).toString());
        }
        entries.add(new Entry(heading, line.strip(), words));
        heading = "";
      }
    }
    if (entries.isEmpty()) {
      throw new UsageException(text("listEmpty", name));
    }
    return new RecordingList(entries);
  }
}
