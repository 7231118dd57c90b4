package org.pendant.language.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;

/** The signatures of everything that can be called: built-in or defined in the text. */
final class Signatures {
  private static final Signature STRUCT =
      new Signature(
          "core",
          Optional.empty(),
          SymbolWalk.STRUCT,
          List.of(),
          Type.STRUCT,
          Unit.NONE,
          "4.1",
          false,
          true,
          "",
          "Makes a struct whose members are the named arguments.");

  private final Source source;
  private final Catalogue catalogue;

  Signatures(Source source, Catalogue catalogue) {
    this.source = source;
    this.catalogue = catalogue;
  }

  /** The function that {@code name} calls in {@code scope}. */
  Optional<Signature> function(String name, FunctionScope scope) {
    return scope.function(name).map(this::of).or(() -> builtin(name));
  }

  Optional<Signature> builtin(String name) {
    return name.equals(SymbolWalk.STRUCT) ? Optional.of(STRUCT) : catalogue.function(name);
  }

  /** Every built-in function, and {@code struct}. */
  List<Signature> builtins() {
    List<Signature> builtins = new ArrayList<>(List.of(STRUCT));
    catalogue.all().stream().filter(other -> other.receiver().isEmpty()).forEach(builtins::add);
    return builtins;
  }

  /** The methods of values of {@code receiver}; of all values when that is ANY. */
  List<Signature> methods(Type receiver) {
    return catalogue.all().stream()
        .filter(method -> method.receiver().isPresent())
        .filter(method -> receiver == Type.ANY || method.receiver().get() == receiver)
        .toList();
  }

  /** The first method of this name, of whatever receiver. */
  Optional<Signature> method(String name) {
    return methods(Type.ANY).stream().filter(method -> method.name().equals(name)).findFirst();
  }

  /** A definition of the text, documented by the comment in front of it. */
  Signature of(Definition definition) {
    List<Parameter> parameters = new ArrayList<>();
    for (ParameterDeclaration declared : definition.parameters()) {
      String defaultText = declared.defaultValue().map(this::defaultText).orElse("");
      boolean required = declared.defaultValue().isEmpty();
      parameters.add(new Parameter(declared.name(), Type.ANY, Unit.NONE, required, defaultText));
    }
    return new Signature(
        "",
        Optional.empty(),
        definition.name(),
        parameters,
        Type.ANY,
        Unit.NONE,
        "",
        false,
        true,
        "",
        leadingComment(definition));
  }

  private String defaultText(Expression value) {
    return ByteText.decoded(source.text(value.range()));
  }

  /** The comment lines directly above the head, without their number signs. */
  private String leadingComment(Definition definition) {
    int line = source.line(definition.range().start());
    List<String> lines = new ArrayList<>();
    while (line > 1 && source.lineText(line - 1).strip().startsWith("#")) {
      line--;
      String words = words(source.lineText(line).strip());
      if (!words.isEmpty()) {
        lines.addFirst(words);
      }
    }
    return ByteText.decoded(String.join("\n", lines));
  }

  private static String words(String comment) {
    int start = 0;
    while (start < comment.length() && comment.charAt(start) == '#') {
      start++;
    }
    return comment.substring(start).strip();
  }
}
