package org.pendant.editors.lsp.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.service.CallSite;
import org.pendant.language.service.DefinedFunction;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.service.Symbol;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.source.ByteText;
import org.pendant.testing.builtin.ExpectationBuiltins;

/**
 * Imported names: what a file of tests has of the scripts that it imports, as a catalogue: their
 * functions beside those of tests.
 */
public final class ImportedNames implements Catalogue {
  private final Catalogue base;
  private final Map<String, Place> functions = new LinkedHashMap<>();
  private final Set<String> variables = new HashSet<>();

  /** A function and the script that it is in. */
  private record Place(Document script, DefinedFunction function) {}

  private ImportedNames(Catalogue base) {
    this.base = base;
  }

  /** Finds the script that a file names. */
  @FunctionalInterface
  interface Finder {
    /** The script {@code name}, as it is written in the file {@code uri}. */
    Optional<Document> find(String uri, String name);
  }

  /**
   * What the scripts have that {@code analysis} imports; empty for a text that imports none.
   *
   * @param uri of the text
   */
  static Optional<ImportedNames> of(ScriptAnalysis analysis, String uri, Finder finder) {
    List<String> files =
        analysis.calls().stream()
            .filter(call -> call.callee().equals(new Symbol.Builtin(ExpectationBuiltins.IMPORT)))
            .flatMap(call -> call.arguments().stream().limit(1))
            .map(CallSite.Given::value)
            .map(range -> ByteText.decoded(analysis.source().text(range)))
            .filter(text -> text.length() > 2 && text.startsWith("\"") && text.endsWith("\""))
            .map(text -> text.substring(1, text.length() - 1))
            .toList();
    if (files.isEmpty()) {
      return Optional.empty();
    }
    ImportedNames names = new ImportedNames(analysis.catalogue());
    files.forEach(file -> finder.find(uri, file).ifPresent(names::add));
    return Optional.of(names);
  }

  private void add(Document script) {
    for (DefinedFunction each : script.analysis().definitions()) {
      functions.put(each.signature().name(), new Place(script, each));
    }
    variables.addAll(script.analysis().globals());
  }

  /** Whether one of the scripts has this global variable. */
  public boolean hasVariable(String name) {
    return variables.contains(name);
  }

  /** The script that defines the function {@code name}. */
  public Optional<Document> script(String name) {
    return Optional.ofNullable(functions.get(name)).map(Place::script);
  }

  /** The function {@code name} of a script. */
  public Optional<DefinedFunction> definition(String name) {
    return Optional.ofNullable(functions.get(name)).map(Place::function);
  }

  @Override
  public Optional<Signature> function(String name) {
    return definition(name).map(DefinedFunction::signature).or(() -> base.function(name));
  }

  @Override
  public Optional<Signature> method(Type receiver, String name) {
    return base.method(receiver, name);
  }

  @Override
  public Collection<Signature> all() {
    List<Signature> all = new ArrayList<>();
    functions.values().forEach(each -> all.add(each.function().signature()));
    all.addAll(base.all());
    return all;
  }
}
