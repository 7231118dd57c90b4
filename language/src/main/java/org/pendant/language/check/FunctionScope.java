package org.pendant.language.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.Qualifier;

/**
 * Function scope: the names of one function, thread or main level, and what they stand for.
 *
 * <p>Variables and functions are separate tables. Nothing here changes after {@link Scopes} is
 * built; interpreter mode gets a new scope for every line through {@link #extendedBy}.
 */
public final class FunctionScope {
  private final Optional<Definition> definition;
  private final Optional<FunctionScope> parent;
  private final boolean mainLevel;
  private final boolean extension;
  private final Set<String> globals;
  private final Map<String, Definition> functions = new LinkedHashMap<>();
  private final Map<String, Reach> names = new LinkedHashMap<>();
  private final IdentityHashMap<Definition, FunctionScope> nested = new IdentityHashMap<>();

  /**
   * From where on a name means the local variable: on the target of its first {@code local}
   * assignment or its place among the parameters, and from the end of that on.
   *
   * @param assigned whether it has a value before the first statement
   */
  private record Reach(int targetStart, int targetEnd, int from, boolean assigned) {
    static final Reach EVERYWHERE = new Reach(0, 0, 0, true);

    /** No {@code local} word: local only if no such global exists. */
    static final Reach FREE =
        new Reach(Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE, false);

    static Reach of(Assign assign) {
      SourceRange target = assign.target().range();
      return new Reach(target.start(), target.end(), assign.range().end(), false);
    }

    static Reach of(ParameterDeclaration parameter) {
      int start = parameter.range().start();
      return new Reach(start, start + parameter.name().length(), parameter.range().end(), true);
    }

    boolean covers(int offset) {
      return offset >= from || (offset >= targetStart && offset < targetEnd);
    }
  }

  private FunctionScope(
      Optional<Definition> definition,
      Optional<FunctionScope> parent,
      boolean mainLevel,
      boolean extension,
      Set<String> globals) {
    this.definition = definition;
    this.parent = parent;
    this.mainLevel = mainLevel;
    this.extension = extension;
    this.globals = globals;
  }

  /** The level around all top-level definitions: functions, no variables. */
  static FunctionScope outermost(Set<String> globals) {
    return new FunctionScope(Optional.empty(), Optional.empty(), false, false, globals);
  }

  static FunctionScope main(Optional<Definition> entry, FunctionScope parent, Set<String> globals) {
    return new FunctionScope(entry, Optional.of(parent), true, false, globals);
  }

  static FunctionScope function(Definition definition, FunctionScope parent) {
    FunctionScope scope =
        new FunctionScope(
            Optional.of(definition), Optional.of(parent), false, false, parent.globals);
    for (ParameterDeclaration parameter : definition.parameters()) {
      scope.names.put(parameter.name(), Reach.of(parameter));
    }
    return scope;
  }

  /** The definition whose body this is; empty for the main level of a fragment. */
  public Optional<Definition> definition() {
    return definition;
  }

  /** Whether this is the program's first level, where every variable is global. */
  public boolean mainLevel() {
    return mainLevel;
  }

  /**
   * What {@code name} stands for when read at {@code offset} of the source. A name that nothing
   * assigns is answered as a local that {@link #locals} does not list: reading it fails.
   */
  public Binding resolve(String name, int offset) {
    Reach reach = names.get(name);
    boolean local = reach != null && reach.covers(offset);
    return !local && globals.contains(name) ? new Binding.Global(name) : new Binding.Local(name);
  }

  /**
   * What a name means that nothing assigns: the manual writes {@code true} and {@code false}, too
   * (15.56).
   */
  public static Optional<Boolean> truth(String name) {
    return switch (name) {
      case "true" -> Optional.of(true);
      case "false" -> Optional.of(false);
      default -> Optional.empty();
    };
  }

  /**
   * The variable that {@code assign} sets, or whose element or member it sets.
   *
   * @throws IllegalArgumentException if the target does not start with a name
   */
  public Binding target(Assign assign) {
    if (!(Assignments.root(assign.target()) instanceof Name name)) {
      throw new IllegalArgumentException(assign.target() + " is no variable");
    }
    return switch (assign.qualifier()) {
      case GLOBAL -> new Binding.Global(name.name());
      case LOCAL, FREE -> resolve(name.name(), name.range().start());
    };
  }

  /**
   * The variables of one call, parameters first, then in the order of their first assignment. Those
   * of an extended scope begin with those of the scope that it extends.
   */
  public List<String> locals() {
    List<String> locals = new ArrayList<>();
    names.forEach(
        (name, reach) -> {
          if (!reach.equals(Reach.FREE) || !globals.contains(name)) {
            locals.add(name);
          }
        });
    return locals;
  }

  /** The names of the program's globals. */
  public Set<String> globals() {
    return Collections.unmodifiableSet(globals);
  }

  /** The function, thread or secondary program that {@code name} calls here. */
  public Optional<Definition> function(String name) {
    FunctionScope scope = this;
    while (true) {
      Definition found = scope.functions.get(name);
      if (found != null) {
        return Optional.of(found);
      }
      if (scope.parent.isEmpty()) {
        return Optional.empty();
      }
      scope = scope.parent.get();
    }
  }

  /**
   * The scope of a definition that stands directly in this one.
   *
   * @throws IllegalArgumentException if it does not
   */
  public FunctionScope nested(Definition inner) {
    FunctionScope scope = nested.get(inner);
    if (scope == null) {
      throw new IllegalArgumentException(inner.name() + " is not defined here");
    }
    return scope;
  }

  /**
   * The scope in which one line of interpreter mode runs (manual 13) when this is the scope that
   * called interpreter mode, or that of the line before. Names known here mean the same there; new
   * ones become locals after those of this scope; functions of the line join the visible ones and
   * hide earlier ones of the same name. This scope stays as it is, so that a discarded line leaves
   * no trace.
   */
  public FunctionScope extendedBy(List<Statement> line) {
    FunctionScope extended =
        new FunctionScope(
            definition, extension ? parent : Optional.of(this), mainLevel, true, globals);
    for (String local : locals()) {
      extended.names.put(local, Reach.EVERYWHERE);
    }
    if (extension) {
      extended.functions.putAll(functions);
    }
    new ScopeBuilder(false).collect(extended, line);
    return extended;
  }

  /**
   * This scope with what interpreted lines have added to another one: a later interpreter mode may
   * stand in another function. Names that are known here keep their meaning.
   *
   * @param lines a scope that {@link #extendedBy} has made, or one without lines
   */
  public FunctionScope with(FunctionScope lines) {
    if (!lines.extension) {
      return this;
    }
    FunctionScope extended = extendedBy(List.of());
    List<String> names = lines.locals();
    int known = lines.parent.orElseThrow().locals().size();
    for (String name : names.subList(known, names.size())) {
      extended.names.putIfAbsent(name, Reach.EVERYWHERE);
    }
    extended.functions.putAll(lines.functions);
    return extended;
  }

  /** The functions that are defined directly here, by name. */
  Map<String, Definition> ownFunctions() {
    return functions;
  }

  /** The level around this one. */
  Optional<FunctionScope> parent() {
    return parent;
  }

  /** Names of all functions visible here, nearest first. */
  List<String> visibleFunctions() {
    List<String> visible = new ArrayList<>();
    for (Optional<FunctionScope> at = Optional.of(this); at.isPresent(); at = at.get().parent) {
      visible.addAll(at.get().functions.keySet());
    }
    return visible;
  }

  /** Whether there is a variable of this name here. */
  boolean knows(String name) {
    return binds(name) || globals.contains(name);
  }

  /** Whether some assignment or parameter makes a local of this name. */
  boolean binds(String name) {
    return names.containsKey(name);
  }

  /** Whether the local {@code name} has a value before the first statement. */
  boolean startsAssigned(String name) {
    Reach reach = names.get(name);
    return reach != null && reach.assigned();
  }

  void declare(Definition inner, FunctionScope scope) {
    functions.put(inner.name(), inner);
    nested.put(inner, scope);
  }

  /** Notes an assignment to the plain name {@code name} that is not a {@code global} one. */
  void bind(String name, Assign assign) {
    boolean local = assign.qualifier() == Qualifier.LOCAL && !mainLevel;
    if (local) {
      names.merge(name, Reach.of(assign), (old, found) -> old.equals(Reach.FREE) ? found : old);
    } else if (!mainLevel || !globals.contains(name)) {
      names.putIfAbsent(name, Reach.FREE);
    }
  }
}
