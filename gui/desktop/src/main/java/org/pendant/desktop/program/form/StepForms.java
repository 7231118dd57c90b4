package org.pendant.desktop.program.form;

import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.Section;
import org.pendant.project.program.TemplateStep;

/** Step forms: the form of any node. */
final class StepForms {
  private StepForms() {}

  static NodeForm of(FormContext context) {
    return switch (context.node().step()) {
      case Section step -> SectionForms.of(context, step);
      case MotionStep step -> MotionForms.of(context, step);
      case ActionStep step -> ActionForms.of(context, step);
      case FlowStep step -> FlowForms.of(context, step);
      case TemplateStep step -> TemplateForms.of(context, step);
      case ForeignStep step -> ForeignForms.of(context, step);
    };
  }
}
