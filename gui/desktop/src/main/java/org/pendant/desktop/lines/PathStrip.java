package org.pendant.desktop.lines;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.Settings;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.RunProfile;

/**
 * Path strip: what stands beside the lines and nodes of the program that ran last: what each of
 * them took. It stays until the text of the line changes or the next run has taken its place. It
 * has no Swing; one thread uses it, the dispatch thread.
 */
public final class PathStrip {
  private static final String SETTING = "view.path-strip";

  /** A line that took less and did not move the arm is not worth a note, s. */
  private static final double MIN_S = 0.01;

  private static final long PERIOD_MS = 250;

  /** So many runs are remembered, the newest: a branch goes back to one of them. */
  private static final int MAX_RUNS = 20;

  private final Settings settings;
  private final Supplier<RunProfile> source;
  private final Supplier<Long> clockMs;
  private Notes sink = (program, notes) -> {};
  private Optional<Ran> next = Optional.empty();
  private boolean starting;

  /** What has run, oldest first; none for texts that are not shown. */
  private final SequencedMap<RunKey, Optional<Ran>> runs = new LinkedHashMap<>();

  private Optional<Ran> ran = Optional.empty();
  private RunProfile profile = RunProfile.NONE;
  private PoseForm units = PoseForm.STANDARD;
  private long askedMs = Long.MIN_VALUE / 2;
  private String textNow = "";
  private KeptLines kept = KeptLines.between("", "");
  private boolean on;
  private boolean shownOn;
  private Map<Integer, LineStatistics> lines = Map.of();
  private GeneratedScript nodesOf = GeneratedScript.EMPTY;
  private Map<Long, LineNote> nodes = Map.of();

  private Consumer<Optional<Ran>> back = before -> {};

  /**
   * A program that was started.
   *
   * @param received whether others have sent it
   */
  public record Ran(ProgramDocument document, RunScript script, boolean received) {}

  /** A run, also among those of the other controllers of a cell. */
  private record RunKey(long run, String name, long firstFrame) {
    static RunKey of(RunProfile profile) {
      return new RunKey(profile.run(), profile.name(), profile.firstFrame());
    }
  }

  /** Shows notes beside the lines of a program. */
  @FunctionalInterface
  public interface Notes {
    /** Shows these, by line from 1. */
    void show(ProgramDocument program, Map<Integer, LineNote> notes);
  }

  /** Takes the profile from {@code source}, a few times a second. */
  public PathStrip(Settings settings, Supplier<RunProfile> source, Supplier<Long> clockMs) {
    this.settings = settings;
    this.source = source;
    this.clockMs = clockMs;
    on = settings.get(SETTING).map(Boolean::parseBoolean).orElse(true);
  }

  /** Shows what stands beside lines in {@code editor}. */
  public void showIn(Notes editor) {
    sink = editor;
  }

  /** Adds what turns it on and off. */
  public void addTo(ActionTable actions) {
    actions.add(
        Action.of(
                "view.path-strip", LineTexts.text("pathStripBesideLinesAndNodes"), "", this::toggle)
            .checked(() -> on));
  }

  private void toggle() {
    on = !on;
    settings.put(SETTING, String.valueOf(on));
    askedMs = Long.MIN_VALUE / 2;
    refresh();
  }

  /** A program is about to start. */
  public void beforeRun(ProgramDocument program, RunScript script) {
    next = Optional.of(new Ran(program, script, false));
    starting = true;
  }

  /** A program that is none of the user's has started; its text is shown, or not. */
  public void strangerStarted(Optional<ProgramDocument> received) {
    next =
        received.map(program -> new Ran(program, RunScript.whole(program.script().source()), true));
    starting = true;
  }

  /** Looks for what has changed. */
  public void refresh() {
    long now = clockMs.get();
    if (now - askedMs < PERIOD_MS) {
      return;
    }
    askedMs = now;
    RunProfile fresh = source.get();
    PoseForm form = FormMemory.read(settings);
    String text = ran.map(each -> each.document().script().text()).orElse("");
    boolean same =
        fresh.equals(profile) && form.equals(units) && text.equals(textNow) && on == shownOn;
    if (same) {
      return;
    }
    if (fresh.run() != 0 && !RunKey.of(fresh).equals(RunKey.of(profile))) {
      begin(RunKey.of(fresh));
    }
    profile = fresh;
    units = form;
    shownOn = on;
    show();
  }

  /**
   * Has {@code listener} told when an earlier run is the last one again, as after a branch.
   *
   * @param listener gets what ran; empty if that is not shown
   */
  public void whenBack(Consumer<Optional<Ran>> listener) {
    back = listener;
  }

  private void begin(RunKey run) {
    boolean before = runs.containsKey(run);
    if (starting && !before) {
      starting = false;
      runs.put(run, next);
      if (runs.size() > MAX_RUNS) {
        runs.pollFirstEntry();
      }
    }
    ran.ifPresent(last -> sink.show(last.document(), Map.of()));
    ran = runs.getOrDefault(run, Optional.empty());
    textNow = "";
    kept = KeptLines.between("", "");
    if (before) {
      back.accept(ran);
    }
  }

  private void show() {
    nodesOf = GeneratedScript.EMPTY;
    if (ran.isEmpty()) {
      return;
    }
    Ran shown = ran.get();
    String text = shown.document().script().text();
    if (!text.equals(textNow)) {
      textNow = text;
      kept = KeptLines.between(shown.script().shown(), text);
    }
    Map<Integer, LineStatistics> now = new HashMap<>();
    for (LineStatistics each : on ? profile.lines() : List.<LineStatistics>of()) {
      int line = kept.now(shown.script().lines().toShown(each.line()));
      if (line > 0 && (each.moved() || each.timeS() >= MIN_S)) {
        now.merge(line, each, LineStatistics::and);
      }
    }
    lines = now;
    Map<Integer, LineNote> notes = new HashMap<>();
    now.forEach((line, statistics) -> notes.put(line, note(statistics)));
    sink.show(shown.document(), notes);
  }

  private LineNote note(LineStatistics statistics) {
    return new LineFigures(units).note(statistics, profile.share(statistics));
  }

  /** What the lines of the last run took. */
  public RunProfile profile() {
    return profile;
  }

  /**
   * What a line of a program took of the last run, in words; empty if it took nothing.
   *
   * @param place what the line is called in a sentence
   */
  public Optional<String> about(ProgramDocument program, int line, String place) {
    return ran.filter(each -> each.document() == program)
        .flatMap(each -> Optional.ofNullable(lines.get(line)))
        .map(took -> LineTexts.text("inTheLastRun", StateWords.capital(place), note(took).whole()));
  }

  /**
   * What a worst moment is called, such as {@code nearest to a safety plane: 4 mm to Table (line
   * 12)}.
   *
   * @param place what a line is called in a sentence
   */
  public String words(RunProfile.Moment moment, IntFunction<String> place) {
    return new LineFigures(units).moment(moment, place);
  }

  /** What stands beside the nodes of a program, by their keys. */
  public Map<Long, LineNote> nodes(ProgramDocument program, GeneratedScript script) {
    if (ran.filter(each -> each.document() == program).isEmpty()
        || !script.text().equals(textNow)) {
      return Map.of();
    }
    if (script.equals(nodesOf)) {
      return nodes;
    }
    Map<Long, LineStatistics> sums = new HashMap<>();
    lines.forEach(
        (line, statistics) ->
            script
                .at(line)
                .map(NodeLines::key)
                .ifPresent(key -> sums.merge(key, statistics, LineStatistics::and)));
    Map<Long, LineNote> notes = new HashMap<>();
    sums.forEach((key, statistics) -> notes.put(key, note(statistics)));
    nodesOf = script;
    nodes = notes;
    return nodes;
  }
}
