package org.pendant.testing.source;

import java.util.HashSet;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.syntax.Script;
import org.pendant.script.function.Builtins;
import org.pendant.testing.builtin.TestBuiltins;

/** Mocked functions of a program: those that ask for a mock before they do anything. */
public final class MockedFunctions {
  private final Set<String> names;
  private final Set<String> found = new HashSet<>();

  /**
   * The functions of one program.
   *
   * @param names that tests replace, whether or not the program has them
   */
  public MockedFunctions(Set<String> names) {
    this.names = names;
  }

  /** The same script with functions that ask. */
  public Script into(Script script) {
    Definitions.each(
        script.statements(),
        each -> {
          if (names.contains(each.name())) {
            found.add(each.name());
          }
        });
    return Definitions.mockable(script, names);
  }

  /** The same catalogue with builtins that ask. */
  public Builtins<ControlBox> builtins(Builtins<ControlBox> builtins) {
    names.stream().filter(each -> builtins.find(each).isPresent()).forEach(found::add);
    return TestBuiltins.mockable(builtins, names);
  }

  /** Those of the names that there are. */
  public Set<String> found() {
    return Set.copyOf(found);
  }
}
