package org.pendant.language.check;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;

/**
 * Scopes: what every name of a program stands for (manual 9 and 10.1), decided from the whole text
 * before anything runs.
 *
 * <ul>
 *   <li>Global are all names assigned at the main level, with or without a word before them and
 *       also inside its {@code if} and {@code while} blocks, and every {@code global x = ...}.
 *   <li>In a function or thread, a parameter is local, from the end of its own default value on; a
 *       name is local after its first {@code local} assignment, whose right side still sees the
 *       outer meaning; any other name is the global of that name if there is one anywhere, else
 *       local.
 *   <li>A nested function sees globals but no local of the function around it.
 *   <li>A function is visible in the whole body that defines it and in the functions nested there.
 * </ul>
 */
public final class Scopes {
  private final Set<String> globals;
  private final FunctionScope outermost;
  private final FunctionScope main;
  private final IdentityHashMap<Definition, FunctionScope> scopes;
  private final List<Definition> definitions;

  private Scopes(ScopeBuilder built, FunctionScope outermost, FunctionScope main) {
    this.globals = Collections.unmodifiableSet(built.globals());
    this.outermost = outermost;
    this.main = main;
    this.scopes = built.scopes();
    this.definitions = List.copyOf(built.definitions());
  }

  /** The scopes of {@code form}. */
  public static Scopes of(ProgramForm form) {
    ScopeBuilder builder = new ScopeBuilder(true);
    FunctionScope outermost = FunctionScope.outermost(builder.globals());
    FunctionScope main = FunctionScope.main(form.entry(), outermost, builder.globals());
    for (Definition sibling : form.siblings()) {
      builder.define(outermost, sibling);
    }
    if (form.entry().isPresent()) {
      Definition entry = form.entry().get();
      builder.enter(outermost, entry, main);
      for (ParameterDeclaration parameter : entry.parameters()) {
        builder.globals().add(parameter.name());
      }
    }
    builder.collect(main, form.body());
    return new Scopes(builder, outermost, main);
  }

  /**
   * The names of all globals, in the order of their first assignment. Optional parameters of the
   * program's own function are among them; they start with their default.
   */
  public Set<String> globals() {
    return globals;
  }

  /** The main level: the program's body, or all statements of a fragment. */
  public FunctionScope mainScope() {
    return main;
  }

  /** Every definition of the program, nested ones after the one around them. */
  public List<Definition> definitions() {
    return definitions;
  }

  /**
   * The scope of {@code definition}; for the program's own function, that is {@link #mainScope}.
   *
   * @throws IllegalArgumentException if it is not part of this program
   */
  public FunctionScope scope(Definition definition) {
    FunctionScope scope = scopes.get(definition);
    if (scope == null) {
      throw new IllegalArgumentException(definition.name() + " is not part of this program");
    }
    return scope;
  }

  /** The level around the top-level definitions. */
  FunctionScope outermost() {
    return outermost;
  }
}
