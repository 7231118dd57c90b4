package org.pendant.language.service;

import java.util.Optional;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.SourceRange;

/**
 * The call around an offset.
 *
 * @param signature what is called; functions of the text have their leading comment as
 *     documentation
 * @param callee where its name stands
 * @param active the index of the parameter being given, or -1 when there is no such parameter
 */
public record SignatureHelp(Signature signature, SourceRange callee, int active) {

  /** The parameter being given. */
  public Optional<Parameter> activeParameter() {
    return active < 0 ? Optional.empty() : Optional.of(signature.parameters().get(active));
  }

  static SignatureHelp of(Lexemes lexemes, CallPlace place, Signature signature) {
    int active =
        place
            .argumentName(lexemes)
            .map(name -> indexOf(signature, name))
            .orElse(place.position() < signature.parameters().size() ? place.position() : -1);
    return new SignatureHelp(signature, lexemes.get(place.opener() - 1).range(), active);
  }

  private static int indexOf(Signature signature, String name) {
    for (int i = 0; i < signature.parameters().size(); i++) {
      if (signature.parameters().get(i).named(name)) {
        return i;
      }
    }
    return -1;
  }
}
