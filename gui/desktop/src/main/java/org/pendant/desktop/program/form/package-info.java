/**
 * Node forms: one for each kind of node. Open {@link org.pendant.desktop.program.form.NodeForms}
 * and {@link org.pendant.desktop.program.form.FormHost} first. What a form holds is data, made anew
 * from the program by {@code StepForms}; controls only show it.
 */
package org.pendant.desktop.program.form;
