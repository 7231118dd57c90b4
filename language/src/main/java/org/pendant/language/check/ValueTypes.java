package org.pendant.language.check;

import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Type;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Name;

/**
 * Value types: what values are as far as the text tells: the checker's own knowledge, for editors.
 */
public final class ValueTypes {
  private final Survey survey;
  private final Inference inference;

  private ValueTypes(Survey survey, Inference inference) {
    this.survey = survey;
    this.inference = inference;
  }

  /**
   * The types of a program, which may have errors.
   *
   * @param scopes those of {@code form}
   */
  public static ValueTypes of(ProgramForm form, Scopes scopes, Catalogue catalogue) {
    Inference inference = new Inference(catalogue);
    return new ValueTypes(Survey.of(form, scopes, inference), inference);
  }

  /** What the variable holds whenever it has a value; ANY when that differs or is not known. */
  public Type variable(FunctionScope scope, Binding binding) {
    return type(survey.kind(scope, binding));
  }

  /** What {@code expression} gives when it stands in {@code scope}; ANY when not known. */
  public Type expression(Expression expression, FunctionScope scope) {
    return expression instanceof Name name
        ? variable(scope, scope.resolve(name.name(), name.range().start()))
        : type(inference.kind(expression, scope));
  }

  private static Type type(StaticType kind) {
    return switch (kind) {
      case ANY -> Type.ANY;
      case BOOL -> Type.BOOL;
      case NUMBER -> Type.NUMBER;
      case STRING -> Type.STRING;
      case POSE -> Type.POSE;
      case LIST -> Type.LIST;
      case MATRIX -> Type.MATRIX;
      case STRUCT -> Type.STRUCT;
    };
  }
}
