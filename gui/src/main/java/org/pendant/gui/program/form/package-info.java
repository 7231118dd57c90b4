/**
 * A form for each kind of node. Open {@link org.pendant.gui.program.form.NodeForms} and {@link
 * org.pendant.gui.program.form.FormHost} first. What a form holds is data, made anew from the
 * program by {@code StepForms}; controls only show it.
 */
package org.pendant.gui.program.form;
