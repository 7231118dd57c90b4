/** A form for each kind of node. Open {@link org.pendant.gui.program.form.FormHost} first. */
package org.pendant.gui.program.form;
