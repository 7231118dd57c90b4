package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.language.source.Source;

/**
 * Started program: one that was started, such as the last one, and where its lines are in the text
 * as it is at the moment: people edit a program while it runs. One thread uses it, the dispatch
 * thread.
 */
public final class StartedProgram {
  private Optional<ProgramDocument> document = Optional.empty();
  private String text = "";
  private String mapped = "";
  private LineMap lines = LineMap.between("", "");
  private RunScript script = RunScript.whole(Source.of("", ""));
  private boolean stranger;

  /** {@code program} is started as it stands, or a part of it, or was some time ago. */
  public void start(ProgramDocument program, RunScript run) {
    document = Optional.of(program);
    script = run;
    text = run.shown();
    mapped = text;
    lines = LineMap.between(text, text);
    stranger = false;
  }

  /**
   * A program that is none of the user's was started; its lines stay as they are.
   *
   * @param received its text as it is shown, if it is
   */
  public void startStranger(Optional<ProgramDocument> received) {
    document = received;
    script = RunScript.whole(received.map(ProgramDocument::source).orElse(Source.of("", "")));
    text = received.map(ProgramDocument::text).orElse("");
    mapped = text;
    lines = LineMap.between(text, text);
    stranger = true;
  }

  /** Whether the text of what was started is not shown. */
  public boolean hidden() {
    return stranger && document.isEmpty();
  }

  /** The program; empty for one that is not shown. */
  public Optional<ProgramDocument> document() {
    return document;
  }

  boolean is(ProgramDocument program) {
    return document.filter(each -> each == program).isPresent();
  }

  /** Whether the text is still the one that runs. */
  boolean unchanged() {
    return lines().unchanged();
  }

  /** The line of the present text where line {@code run} of the running one is. */
  public int toNow(int run) {
    return stranger ? run : lines().toNow(script.lines().toShown(run));
  }

  /** The lines of the running text that line {@code now} of the present one was. */
  List<Integer> toRun(int now) {
    return stranger ? List.of(now) : script.lines().toRun(lines().toOld(now));
  }

  /** What was started. */
  public RunScript script() {
    return script;
  }

  private LineMap lines() {
    String now = document.map(each -> each.script().text()).orElse(text);
    if (!now.equals(mapped)) {
      mapped = now;
      lines = LineMap.between(text, now);
    }
    return lines;
  }
}
