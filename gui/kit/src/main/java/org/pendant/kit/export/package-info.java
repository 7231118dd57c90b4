/**
 * Export: how screens hand what they show to a file. Open {@link org.pendant.kit.export.SaveDialog}
 * first.
 */
package org.pendant.kit.export;
