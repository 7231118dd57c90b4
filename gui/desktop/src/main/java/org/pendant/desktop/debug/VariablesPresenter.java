package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.Set;
import java.util.function.LongSupplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Variables presenter: what the panel of variables shows: those of the call that is looked at while
 * a program is paused, otherwise samples of the program that runs or ran last, about ten times a
 * second. It has no Swing; one thread uses it, the dispatch thread.
 */
final class VariablesPresenter {
  private final ValueTree tree;
  private final Favourites favourites;
  private final HiddenNames hidden;
  private final LiveTree live;
  private String program = "";
  private String filter = "";
  private VariableSamples counted = VariableSamples.NONE;
  private long hiddenCount;

  /**
   * Nothing yet.
   *
   * @param tree shows the values; a debugger fills it while a program is paused
   * @param clockMs any clock that runs, ms
   */
  VariablesPresenter(
      ValueTree tree, Favourites favourites, HiddenNames hidden, LongSupplier clockMs) {
    this.tree = tree;
    this.favourites = favourites;
    this.hidden = hidden;
    live =
        new LiveTree(
            tree,
            clockMs,
            (samples, running, unfolded) ->
                LiveValues.of(samples, running ? "" : program, unfolded));
    favourites.addListener(this::order);
    hidden.addListener(this::order);
    order();
  }

  /**
   * Takes the newest snapshot.
   *
   * @param held whether the tree shows what a debugger found
   */
  void refresh(ControllerState state, boolean held) {
    if (!state.program().name().equals(program)) {
      program = state.program().name();
      order();
    }
    live.refresh(state, held);
    if (!state.variables().equals(counted)) {
      counted = state.variables();
      count();
    }
  }

  /** Shows only variables whose names have every word of {@code text}. */
  void filter(String text) {
    filter = text;
    order();
  }

  private void order() {
    Set<String> first = favourites.of(program);
    tree.setOrder(new ValueOrder(filter, first::contains, each -> hidden.hides(program, each)));
    count();
  }

  private void count() {
    Set<String> first = favourites.of(program);
    hiddenCount =
        counted.globals().stream()
            .map(VariableSample::name)
            .filter(each -> hidden.hides(program, each) && !first.contains(each))
            .count();
  }

  /** Has a variable come first from now on, or no longer; parts of variables cannot. */
  void toggleFavourite(ValueRow.Value row) {
    if (row.level() == 0) {
      favourites.toggle(program, row.key().expression());
    }
  }

  /** What to say in place of the table; empty while there are rows. */
  String note() {
    if (!tree.rows().isEmpty()) {
      return "";
    }
    if (!filter.isBlank() && !live.samples().empty()) {
      return text("noVariableHasInItsName", filter.strip());
    }
    if (program.isEmpty()) {
      return text("noProgramHasRunYetRun");
    }
    return hiddenCount > 0
        ? text("theProgramHasNoVariablesBut", program)
        : text("theProgramHasNoVariables", program);
  }

  /** How many variables are not shown, and why; empty for none. */
  String omission() {
    int omitted = live.samples().omitted();
    if (omitted > 0) {
      return text("moreVariablesAreShownOnlyWhile", omitted);
    }
    return hiddenCount > 0 && filter.isBlank() ? text("thatNodesMakeAreHidden", hiddenCount) : "";
  }
}
