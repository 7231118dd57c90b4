package org.pendant.language.check;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;

/**
 * Function head: what a call must look like, for built-in and defined functions alike.
 *
 * @param positions where each parameter stands, by all its names
 * @param text the head for messages
 */
record FunctionHead(
    String name, List<Parameter> parameters, Map<String, Integer> positions, String text) {

  static FunctionHead of(Signature signature) {
    return of(signature.name(), signature.parameters(), signature.head());
  }

  static FunctionHead of(Definition definition) {
    List<Parameter> parameters = new ArrayList<>();
    for (ParameterDeclaration declared : definition.parameters()) {
      boolean required = declared.defaultValue().isEmpty();
      parameters.add(new Parameter(declared.name(), Type.ANY, Unit.NONE, required, ""));
    }
    return of(definition.name(), parameters, definition.head());
  }

  private static FunctionHead of(String name, List<Parameter> parameters, String text) {
    Map<String, Integer> positions = new HashMap<>();
    for (int i = 0; i < parameters.size(); i++) {
      positions.putIfAbsent(parameters.get(i).name(), i);
      for (String alias : parameters.get(i).aliases()) {
        positions.putIfAbsent(alias, i);
      }
    }
    return new FunctionHead(name, List.copyOf(parameters), positions, text);
  }
}
