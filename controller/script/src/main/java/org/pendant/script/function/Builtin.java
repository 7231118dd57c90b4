package org.pendant.script.function;

import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Signature;
import org.pendant.script.value.Value;

/**
 * Builtin: a function or method of the manual, how it is called and what it does.
 *
 * @param <H> what programs run on
 * @param defaults the value of each parameter when the call leaves it out, in order; empty for
 *     required parameters and for those whose absence the code looks at itself ({@link Call#given})
 * @param costNs computing time of a call, see {@link Work#charge}
 * @param changesReceiver whether it changes the object that it is a method of
 */
public record Builtin<H extends Host>(
    Signature signature,
    List<Optional<Value>> defaults,
    Effect effect,
    int costNs,
    boolean changesReceiver,
    BuiltinCode<H> code) {
  public Builtin {
    defaults = List.copyOf(defaults);
  }

  /** The same function as a call sees it that leaves out the arguments after the first ones. */
  public Builtin<H> withFirst(int count) {
    Signature shorter =
        new Signature(
            signature.module(),
            signature.receiver(),
            signature.name(),
            signature.parameters().subList(0, count),
            signature.result(),
            signature.resultUnit(),
            signature.section(),
            signature.physicalTime(),
            signature.allowedInSecondary(),
            signature.deprecated(),
            signature.documentation());
    return new Builtin<>(
        shorter, defaults.subList(0, count), effect, costNs, changesReceiver, code);
  }

  /** The same function with other code, for a thread that is run ahead. */
  public Builtin<H> doing(BuiltinCode<H> other) {
    return new Builtin<>(signature, defaults, effect, costNs, changesReceiver, other);
  }

  /**
   * Whether a call learns no more than the one before in the same frame. What asks with more than
   * the number or name of a thing computes something of its arguments.
   */
  public boolean repeatsItself() {
    return effect == Effect.SENSES || (effect == Effect.ASKS && signature.parameters().size() <= 1);
  }

  public String name() {
    return signature.name();
  }
}
