//! Linear least squares by Householder's QR. No physical unit.

use nalgebra::{DMatrix, DVector};

/// The coefficients of columns for the best approximation of values.
pub(crate) struct Fit {
    pub coefficients: Vec<f64>,
    /// values minus the approximation
    pub residual: Vec<f64>,
    /// the variances of the coefficients if those of the values are 1
    pub variances: Vec<f64>,
}

/// Fits columns that are as long as the values; `None` if there are fewer values than columns, or if columns depend on each
/// other.
pub(crate) fn fit(columns: &[Vec<f64>], values: &[f64]) -> Option<Fit> {
    let (rows, width) = (values.len(), columns.len());
    (rows >= width).then_some(())?;
    let qr = DMatrix::from_fn(rows, width, |row, column| columns[column][row]).qr();
    let r = qr.r();
    let mut turned = DVector::from_column_slice(values);
    qr.q_tr_mul(&mut turned);
    let solved = r.solve_upper_triangular(&turned.rows(0, width))?;
    let residual = (0..rows)
        .map(|row| columns.iter().zip(solved.iter()).fold(values[row], |left, (column, c)| left - column[row] * c))
        .collect();
    // (R' R)^-1 = R^-1 R^-T: its diagonal elements are the squared norms of the rows of R^-1.
    let inverse = r.solve_upper_triangular(&DMatrix::identity(width, width))?;
    let variances = (0..width).map(|row| inverse.row(row).norm_squared()).collect();
    Some(Fit { coefficients: solved.iter().copied().collect(), residual, variances })
}
