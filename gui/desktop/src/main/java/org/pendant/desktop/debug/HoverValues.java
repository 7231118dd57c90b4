package org.pendant.desktop.debug;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.script.variables.VariableSamples;

/**
 * Hover values: what a variable in the text of a program is: as the call that is looked at sees it
 * while the debugger has paused the program, otherwise what it was last.
 */
public final class HoverValues {
  private final DebugPresenter debug;
  private final Supplier<VariableSamples> samples;

  /**
   * Values of the program that was started last.
   *
   * @param samples the newest of a program that is not paused, or those of the past that is shown
   */
  public HoverValues(DebugPresenter debug, Supplier<VariableSamples> samples) {
    this.debug = debug;
    this.samples = samples;
  }

  /** The value of a variable, as text; empty if it is not known. */
  public Optional<String> of(ProgramDocument program, String name) {
    if (debug.breakpoints().started().filter(program::equals).isEmpty()) {
      return Optional.empty();
    }
    if (debug.showsValues()) {
      Optional<String> held = debug.variables().text(name);
      if (held.isPresent()) {
        return held;
      }
    }
    VariableSamples now = samples.get();
    return Stream.concat(now.locals().stream(), now.globals().stream())
        .map(each -> each.variable())
        .filter(each -> each.name().equals(name) && each.kind().isPresent())
        .map(each -> each.text())
        .findFirst();
  }
}
