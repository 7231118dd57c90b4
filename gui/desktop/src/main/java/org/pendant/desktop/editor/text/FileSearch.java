package org.pendant.desktop.editor.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.pendant.language.source.ByteText;

/**
 * File search: looks through the scripts of a folder and the folders in it. Slow: for a worker
 * thread.
 *
 * @param folder where to look
 * @param query what for
 */
public record FileSearch(Path folder, SearchQuery query) {
  /** More places than a user reads. */
  public static final int MAX_PLACES = 2_000;

  /** More files than a folder of programs has. */
  public static final int MAX_FILES = 10_000;

  private static final long MAX_BYTES = 4L << 20;

  /**
   * How it went.
   *
   * @param files how many scripts were read
   * @param places how many places were found
   * @param skipped how many could not be read or are larger than 4 MiB
   * @param complete whether all was looked at: it was not cancelled and no limit was met
   */
  public record Summary(int files, int places, int skipped, boolean complete) {

    /** {@code 3 places in 12 scripts; 1 not read}. */
    public String sentence() {
      String found =
          ScriptTexts.text(
              "found",
              ScriptTexts.text(places == 1 ? "onePlace" : "places", places),
              ScriptTexts.text(files == 1 ? "inOneScript" : "inScripts", files));
      return skipped == 0 ? found : ScriptTexts.text("foundButNotRead", found, skipped);
    }
  }

  /** Who wants to know how far a search is. */
  @FunctionalInterface
  public interface Progress {
    /** {@code done} of {@code all} scripts have been looked at. */
    void at(int done, int all);
  }

  /**
   * Looks.
   *
   * @param found takes every place, file by file in the order of their names
   * @param progress told how many scripts there are and how many of them have been read
   * @param cancelled asked before each file
   * @throws IOException if the folder cannot be read
   */
  public Summary run(Consumer<Place> found, Progress progress, BooleanSupplier cancelled)
      throws IOException {
    int read = 0;
    int places = 0;
    int skipped = 0;
    List<Path> scripts = ScriptFolder.list(folder, MAX_FILES + 1, cancelled);
    for (Path script : scripts) {
      if (cancelled.getAsBoolean() || places >= MAX_PLACES || read >= MAX_FILES) {
        return new Summary(read, places, skipped, false);
      }
      progress.at(read + skipped, scripts.size());
      Optional<String> text = text(script);
      if (text.isEmpty()) {
        skipped++;
        continue;
      }
      read++;
      String name = folder.relativize(script).toString();
      for (TextSpan span : query.in(text.get())) {
        if (places++ < MAX_PLACES) {
          found.accept(Place.of(name, Optional.of(script), text.get(), span));
        }
      }
    }
    int shown = Math.min(places, MAX_PLACES);
    return new Summary(read, shown, skipped, places <= MAX_PLACES);
  }

  private static Optional<String> text(Path script) {
    try {
      if (Files.size(script) > MAX_BYTES) {
        return Optional.empty();
      }
      byte[] bytes = Files.readAllBytes(script);
      String text = ByteText.decoded(new String(bytes, StandardCharsets.ISO_8859_1));
      return Optional.of(text.replace("\r\n", "\n"));
    } catch (IOException e) {
      return Optional.empty(); // counted as skipped
    }
  }
}
