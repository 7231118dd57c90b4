package org.pendant.testing.builtin;

import java.util.Collection;
import java.util.Optional;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;

/** Catalogue of what people may write in a file of tests, for editors. */
public final class TestCatalogue implements Catalogue {
  private static final String ENDING = "_test.script";

  private final Catalogue all = TestBuiltins.create();

  /** Whether a text of this name is a file of tests. */
  public static boolean isFor(String name) {
    return name.endsWith(ENDING);
  }

  @Override
  public Optional<Signature> function(String name) {
    return all.function(name).filter(each -> !TestBuiltins.isHidden(each.name()));
  }

  @Override
  public Optional<Signature> method(Type receiver, String name) {
    return all.method(receiver, name);
  }

  @Override
  public Collection<Signature> all() {
    return all.all().stream().filter(each -> !TestBuiltins.isHidden(each.name())).toList();
  }
}
