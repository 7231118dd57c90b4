package org.pendant.controller.call;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.value.Value;
import org.pendant.language.signature.Signature;

/**
 * A built-in function or method: how it is called and what it does.
 *
 * @param defaults the value of each parameter when the call leaves it out, in order; empty for
 *     required parameters and for those whose absence the code looks at itself ({@link Call#given})
 */
public record Builtin(Signature signature, List<Optional<Value>> defaults, BuiltinCode code) {
  public Builtin {
    defaults = List.copyOf(defaults);
  }

  public String name() {
    return signature.name();
  }
}
