/**
 * How screens hand what they show to a file. Open {@link org.pendant.gui.export.SaveDialog} first.
 */
package org.pendant.gui.export;
