/** Parts of forms. Open {@link org.pendant.kit.form.Measure} first. */
package org.pendant.kit.form;
