/**
 * What the script editor does with text, without a window. Open {@link
 * org.pendant.gui.editor.text.AnalysedText} first.
 */
package org.pendant.gui.editor.text;
