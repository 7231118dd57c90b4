package org.pendant.editors.lsp.text;

import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Catalogue;
import org.pendant.testing.builtin.TestCatalogue;

/** Catalogues: the functions that a file may call, by its name: tests know more than programs. */
public final class Catalogues {
  private final Catalogue ofPrograms = StandardBuiltins.create();
  private final Catalogue ofTests = new TestCatalogue();

  /** Those of a file called {@code fileName}. */
  public Catalogue of(String fileName) {
    return TestCatalogue.isFor(fileName) ? ofTests : ofPrograms;
  }
}
