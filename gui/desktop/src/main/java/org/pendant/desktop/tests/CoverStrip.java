package org.pendant.desktop.tests;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.pendant.desktop.editor.LineCover;
import org.pendant.desktop.editor.LineCover.Reach;
import org.pendant.desktop.lines.KeptLines;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.testing.coverage.FileCoverage;

/**
 * Cover strip: what tests have reached, beside the lines of the scripts that are open. Lines that
 * are edited lose it, and the others say that it is older than the text. It has no Swing; one
 * thread uses it, the dispatch thread.
 */
final class CoverStrip {
  private final Programs programs;
  private final BooleanSupplier on;
  private final Function<ProgramDocument, Optional<Reached>> source;
  private final Sink sink;

  /** By identity: a document is the one that is open. */
  private final IdentityHashMap<ProgramDocument, Shown> shown = new IdentityHashMap<>();

  /** Shows what was reached beside the lines of a program. */
  @FunctionalInterface
  interface Sink {
    /** Shows these, by line from 1. */
    void show(ProgramDocument program, Map<Integer, LineCover> lines);
  }

  /**
   * What was reached of a file.
   *
   * @param tests how many ran
   */
  record Reached(FileCoverage file, int tests) {}

  /** What is shown, and of what. */
  private record Shown(Reached of, String text, Map<Integer, LineCover> lines) {
    /** Coverage by identity: it is long, and another one after each run. */
    @SuppressWarnings("ReferenceEquality") // so it is meant
    boolean is(Reached other, String now) {
      return of.file() == other.file() && text.equals(now);
    }
  }

  /**
   * A strip that shows nothing yet.
   *
   * @param source what was reached of a program last
   */
  CoverStrip(
      Programs programs,
      BooleanSupplier on,
      Function<ProgramDocument, Optional<Reached>> source,
      Sink sink) {
    this.programs = programs;
    this.on = on;
    this.source = source;
    this.sink = sink;
  }

  /** Looks for what has changed. */
  void refresh() {
    List<ProgramDocument> open = programs.all();
    shown.keySet().removeIf(each -> !open.contains(each));
    for (ProgramDocument each : open) {
      Optional<Reached> reached =
          on.getAsBoolean() && !each.isTree() ? source.apply(each) : Optional.empty();
      if (reached.isPresent()) {
        show(each, reached.get());
      } else if (shown.remove(each) != null) {
        sink.show(each, Map.of());
      }
    }
  }

  private void show(ProgramDocument program, Reached reached) {
    String text = program.text();
    Shown before = shown.get(program);
    if (before == null || !before.is(reached, text)) {
      Map<Integer, LineCover> lines = lines(reached, text);
      shown.put(program, new Shown(reached, text, lines));
      sink.show(program, lines);
    }
  }

  private static Map<Integer, LineCover> lines(Reached reached, String now) {
    Map<Integer, LineCover> then = CoverLines.of(reached.file(), reached.tests());
    if (now.lines().toList().equals(reached.file().text())) {
      return then;
    }
    KeptLines kept = KeptLines.between(String.join("\n", reached.file().text()), now);
    Map<Integer, LineCover> lines = new HashMap<>();
    then.forEach(
        (line, cover) -> {
          int there = kept.now(line);
          if (there > 0) {
            lines.put(there, old(cover));
          }
        });
    return lines;
  }

  private static LineCover old(LineCover cover) {
    return new LineCover(
        cover.reach(),
        true,
        TestsTexts.text("beforeTheTextWasEdited", cover.about()),
        TestsTexts.text("theTextWasEditedSinceThese", cover.whole()));
  }

  /** Whether anything is shown beside a program. */
  boolean shows(ProgramDocument program) {
    return shown.containsKey(program);
  }

  /** The next line that is not reached, or only in part, from the top again behind the last one. */
  OptionalInt next(ProgramDocument program, int line) {
    Shown there = shown.get(program);
    if (there == null) {
      return OptionalInt.empty();
    }
    TreeMap<Integer, LineCover> lines = new TreeMap<>(there.lines());
    return IntStream.concat(
            lines.tailMap(line, false).keySet().stream().mapToInt(Integer::intValue),
            lines.headMap(line, true).keySet().stream().mapToInt(Integer::intValue))
        .filter(each -> lines.get(each).reach() != Reach.ALL)
        .findFirst();
  }
}
